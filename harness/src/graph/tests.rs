//! Orders and circles of small graphs.

use proptest::prelude::*;

use super::*;

fn graph(nodes: usize, edges: &[(usize, usize)]) -> Graph {
    let mut graph = Graph::new(nodes);
    edges.iter().for_each(|&(from, to)| graph.connect(from, to));
    graph
}

#[test]
fn smaller_numbers_come_first_where_there_is_a_choice() {
    assert_eq!(graph(4, &[(3, 0), (3, 1)]).order(), Ok(vec![2, 3, 0, 1]));
}

#[test]
fn a_shortest_circle_is_found() {
    let circle = graph(6, &[(0, 1), (1, 2), (2, 3), (3, 1), (3, 4), (4, 3), (4, 5)]).order().unwrap_err();
    assert_eq!(circle, [3, 4]);
    assert_eq!(graph(2, &[(1, 1)]).order(), Err(vec![1]));
}

#[test]
fn the_first_circle_waits_for_nobody_outside() {
    let graph = graph(5, &[(0, 1), (1, 0), (2, 3), (3, 2), (2, 0), (3, 4)]);
    assert_eq!(graph.first_circle(&[0, 1, 2, 3, 4]), [2, 3]);
    assert_eq!(graph.first_circle(&[0, 1, 4]), [0, 1]);
}

proptest! {
    #[test]
    fn an_order_respects_every_edge_and_a_circle_is_one(
        nodes in 1..12usize,
        edges in prop::collection::vec((0..12usize, 0..12usize), 0..20),
    ) {
        let edges: Vec<_> = edges.into_iter().filter(|&(a, b)| a < nodes && b < nodes).collect();
        let graph = graph(nodes, &edges);
        match graph.order() {
            Ok(order) => {
                prop_assert_eq!(order.len(), nodes);
                let place = |node| order.iter().position(|&other| other == node);
                prop_assert!(edges.iter().all(|&(from, to)| place(from) < place(to)));
            }
            Err(circle) => {
                prop_assert!(!circle.is_empty());
                let next = circle.iter().cycle().skip(1);
                prop_assert!(circle.iter().zip(next).all(|(&from, &to)| edges.contains(&(from, to))));
            }
        }
    }
}
