//! Archives of folders.

use std::fs;
use std::path::Path;

/// Packs a folder into an archive.
pub fn pack(folder: &Path, to: &Path) {
    fn add(writer: &mut zip::ZipWriter<fs::File>, folder: &Path, name: &str) {
        for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
            let name = format!("{name}{}", entry.file_name().to_str().unwrap());
            if entry.file_type().unwrap().is_dir() {
                add(writer, &entry.path(), &format!("{name}/"));
            } else {
                writer.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
                std::io::Write::write_all(writer, &fs::read(entry.path()).unwrap()).unwrap();
            }
        }
    }
    let mut writer = zip::ZipWriter::new(fs::File::create(to).unwrap());
    add(&mut writer, folder, "");
    writer.finish().unwrap();
}
