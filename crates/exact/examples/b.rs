//! scratch
use predicament_exact::Exact; use predicament_predicates::*; use std::time::Instant; use std::hint::black_box;
fn main(){
 let mut x=1u64; let mut r=move||{x=x.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);(x>>11) as f64/9007199254740992.0};
 let np=1000; let nq=1<<15;
 let p2:Vec<[f64;2]>=(0..np).map(|_|[r(),r()]).collect(); let p3:Vec<[f64;3]>=(0..np).map(|_|[r(),r(),r()]).collect();
 let s2=Scene::from_points2(&p2).unwrap(); let s3=Scene::from_points3(&p3).unwrap();
 let e2=Exact.prepare(&s2,Off).unwrap(); let e3=Exact.prepare(&s3,Off).unwrap();
 let mut v=||Vertex::input((r()*np as f64) as usize);
 let q3:Vec<[Vertex;3]>=(0..nq).map(|_|[v(),v(),v()]).collect(); let q4:Vec<[Vertex;4]>=(0..nq).map(|_|[v(),v(),v(),v()]).collect(); let q5:Vec<[Vertex;5]>=(0..nq).map(|_|[v(),v(),v(),v(),v()]).collect();
 let mut out=vec![Sign::Zero;nq];
 let mut t=|name:&str,f:&mut dyn FnMut(&mut [Sign])|{ let mut b=f64::MAX; for _ in 0..200{let i=Instant::now(); f(&mut out); black_box(&out); b=b.min(i.elapsed().as_nanos() as f64/nq as f64);} println!("{name:12} {b:.2}")};
 t("o2 batch",&mut |o|e2.orient2d_batch(Plane::Xy,&q3,o));
 t("o2 single",&mut |o|for(q,o)in q3.iter().zip(o){*o=e2.orient2d(Plane::Xy,q[0],q[1],q[2])});
 t("o3 batch",&mut |o|e3.orient3d_batch(&q4,o));
 t("o3 single",&mut |o|for(q,o)in q4.iter().zip(o){*o=e3.orient3d(q[0],q[1],q[2],q[3])});
 t("ic batch",&mut |o|e2.incircle_batch(&q4,o));
 t("ic single",&mut |o|for(q,o)in q4.iter().zip(o){*o=e2.incircle(q[0],q[1],q[2],q[3])});
 t("is batch",&mut |o|e3.insphere_batch(&q5,o));
 t("is single",&mut |o|for(q,o)in q5.iter().zip(o){*o=e3.insphere(q[0],q[1],q[2],q[3],q[4])});
 let c=|v:Vertex|{let p=s2.point(v);robust::Coord{x:p[0],y:p[1]}};
 let d=|v:Vertex|{let p=s3.point(v);robust::Coord3D{x:p[0],y:p[1],z:p[2]}};
 t("o2 robust",&mut |o|for(q,o)in q3.iter().zip(o){*o=Sign::of(robust::orient2d(c(q[0]),c(q[1]),c(q[2])))});
 t("o3 robust",&mut |o|for(q,o)in q4.iter().zip(o){*o=Sign::of(robust::orient3d(d(q[0]),d(q[1]),d(q[2]),d(q[3])))});
 t("ic robust",&mut |o|for(q,o)in q4.iter().zip(o){*o=Sign::of(robust::incircle(c(q[0]),c(q[1]),c(q[2]),c(q[3])))});
 t("is robust",&mut |o|for(q,o)in q5.iter().zip(o){*o=Sign::of(robust::insphere(d(q[0]),d(q[1]),d(q[2]),d(q[3]),d(q[4])))});
}
