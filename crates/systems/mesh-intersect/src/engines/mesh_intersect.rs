
    // REPLACE. The meshes of union, intersection, difference and symmetric difference, or of some of them. This puts
    // one solid beside the other: a union if they are apart.
    fn mesh_intersect(&self, first: &Mesh, second: &Mesh) -> Result<Results<Mesh>, String> {
        let (mut both, before) = (first.clone(), first.vertices.len() as u32);
        both.vertices.extend(&second.vertices);
        both.triangles.extend(second.triangles.iter().map(|triangle| triangle.map(|v| v + before)));
        Ok(Results { union: Some(both), intersection: None, difference: None, symmetric_difference: None })
    }
}
