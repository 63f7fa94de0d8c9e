(* The lemma of docs/FILTERS.md about incircle: rounding the six differences moves the determinant by no more than
   u (3 P + 14 |D|) to first order, near ties and away from them. `cargo xtask prove` has Coq check this file. *)
Require Import Reals Lra Psatz.
Open Scope R_scope.

(* The largest of one and a magnitude. *)
Definition m (x : R) := Rmax 1 (Rabs x).

Lemma m_cases : forall x, 1 <= m x /\ x <= m x /\ - x <= m x /\ (m x = 1 \/ m x = x \/ m x = - x).
Proof.
  intros. unfold m, Rmax. destruct (Rle_dec _ _); unfold Rabs in *; destruct (Rcase_abs _); lra.
Qed.

Lemma core : forall A C V W,
  -2 <= V <= 2 -> -2 <= W <= 2 ->
  (0 <= A -> 0 <= C -> 0 <= V \/ W <= 0) ->
  (A <= 0 -> C <= 0 -> V <= 0 \/ 0 <= W) ->
  m (V - A) + m (W + C) + Rabs (A + C) <= 3 * m A + 3 * m C.
Proof.
  intros A C V W HV HW H1 H2.
  pose proof (m_cases A) as (a1 & a2 & a3 & _). pose proof (m_cases C) as (c1 & c2 & c3 & _).
  pose proof (m_cases (V - A)) as (_ & _ & _ & v). pose proof (m_cases (W + C)) as (_ & _ & _ & w).
  assert (S : (0 <= A /\ 0 <= C /\ (0 <= V \/ W <= 0)) \/ (A <= 0 /\ C <= 0 /\ (V <= 0 \/ 0 <= W)) \/
              (0 <= A /\ C <= 0) \/ (A <= 0 /\ 0 <= C)).
  { destruct (Rle_dec 0 A), (Rle_dec 0 C); [left | right; right; left | right; right; right | right; left]; lra. }
  destruct S as [(p & q & [s | s]) | [(p & q & [s | s]) | [(p & q) | (p & q)]]]; clear H1 H2;
    destruct v as [v | [v | v]]; destruct w as [w | [w | w]]; rewrite v, w;
    unfold Rabs; destruct (Rcase_abs (A + C)); lra.
Qed.

Section Linear.
Variables wa wb wc ka kb kc : R.

(* The first-order error of rounded differences, in units of u: the sum of |e dD/de| over the six differences. A term
   of row i is split in the shares k_i and 1 - k_i of its minor, and w_i is the share of x_i^2 in the lift. *)
Definition G (a b c : R) :=
  Rabs (2 * wa * a + (kc * c - (kb - 1) * b)) + Rabs (2 * (1 - wa) * a + (kb * b - (kc - 1) * c)) +
  (Rabs (2 * wb * b + (ka * a - (kc - 1) * c)) + Rabs (2 * (1 - wb) * b + (kc * c - (ka - 1) * a))) +
  (Rabs (2 * wc * c + (kb * b - (ka - 1) * a)) + Rabs (2 * (1 - wc) * c + (ka * a - (kb - 1) * b))).

Definition rho (k : R) := Rabs k + Rabs (k - 1).
Definition P (a b c : R) := Rabs a * rho ka + Rabs b * rho kb + Rabs c * rho kc.

Lemma split_abs : forall x y z, x = y + z -> Rabs x <= Rabs y + Rabs z.
Proof. intros x y z ->. apply Rabs_triang. Qed.

Lemma G_sum : forall a b c a' b' c', G (a + a') (b + b') (c + c') <= G a b c + G a' b' c'.
Proof.
  intros. unfold G.
  pose proof (split_abs (2 * wa * (a + a') + (kc * (c + c') - (kb - 1) * (b + b'))) (2 * wa * a + (kc * c - (kb - 1) * b)) (2 * wa * a' + (kc * c' - (kb - 1) * b')) ltac:(ring)).
  pose proof (split_abs (2 * (1 - wa) * (a + a') + (kb * (b + b') - (kc - 1) * (c + c'))) (2 * (1 - wa) * a + (kb * b - (kc - 1) * c)) (2 * (1 - wa) * a' + (kb * b' - (kc - 1) * c')) ltac:(ring)).
  pose proof (split_abs (2 * wb * (b + b') + (ka * (a + a') - (kc - 1) * (c + c'))) (2 * wb * b + (ka * a - (kc - 1) * c)) (2 * wb * b' + (ka * a' - (kc - 1) * c')) ltac:(ring)).
  pose proof (split_abs (2 * (1 - wb) * (b + b') + (kc * (c + c') - (ka - 1) * (a + a'))) (2 * (1 - wb) * b + (kc * c - (ka - 1) * a)) (2 * (1 - wb) * b' + (kc * c' - (ka - 1) * a')) ltac:(ring)).
  pose proof (split_abs (2 * wc * (c + c') + (kb * (b + b') - (ka - 1) * (a + a'))) (2 * wc * c + (kb * b - (ka - 1) * a)) (2 * wc * c' + (kb * b' - (ka - 1) * a')) ltac:(ring)).
  pose proof (split_abs (2 * (1 - wc) * (c + c') + (ka * (a + a') - (kb - 1) * (b + b'))) (2 * (1 - wc) * c + (ka * a - (kb - 1) * b)) (2 * (1 - wc) * c' + (ka * a' - (kb - 1) * b')) ltac:(ring)).
  lra.
Qed.

Lemma scale_abs : forall t x y, x = t * y -> Rabs x = Rabs t * Rabs y.
Proof. intros t x y ->. apply Rabs_mult. Qed.

Lemma G_scale : forall t a b c, G (t * a) (t * b) (t * c) = Rabs t * G a b c.
Proof.
  intros. unfold G.
  rewrite (scale_abs t (2 * wa * (t * a) + _) (2 * wa * a + (kc * c - (kb - 1) * b))) by ring.
  rewrite (scale_abs t (2 * (1 - wa) * (t * a) + _) (2 * (1 - wa) * a + (kb * b - (kc - 1) * c))) by ring.
  rewrite (scale_abs t (2 * wb * (t * b) + _) (2 * wb * b + (ka * a - (kc - 1) * c))) by ring.
  rewrite (scale_abs t (2 * (1 - wb) * (t * b) + _) (2 * (1 - wb) * b + (kc * c - (ka - 1) * a))) by ring.
  rewrite (scale_abs t (2 * wc * (t * c) + _) (2 * wc * c + (kb * b - (ka - 1) * a))) by ring.
  rewrite (scale_abs t (2 * (1 - wc) * (t * c) + _) (2 * (1 - wc) * c + (ka * a - (kb - 1) * b))) by ring.
  ring.
Qed.

Lemma abs_m : forall x y, m (x - y) = Rabs (x / 2 + 1 - (y + 1) / 2) + Rabs (1 - x / 2 + (y - 1) / 2).
Proof.
  intros. unfold m, Rmax. destruct (Rle_dec _ _); unfold Rabs in *; repeat (destruct (Rcase_abs _)); lra.
Qed.

Lemma rho_m : forall k, rho k = m (2 * k - 1).
Proof.
  intros. unfold rho, m, Rmax. destruct (Rle_dec _ _); unfold Rabs in *; repeat (destruct (Rcase_abs _)); lra.
Qed.
End Linear.

Lemma G_turn : forall wa wb wc ka kb kc a b c, G wa wb wc ka kb kc a b c = G wb wc wa kb kc ka b c a.
Proof. intros. unfold G. ring. Qed.

(* One minor stands against another: the largest case of a tie. *)
Lemma pair : forall wa wb wc ka kb kc,
  0 <= wa <= 1 -> 0 <= wc <= 1 ->
  (1 / 2 <= kc -> 1 / 2 <= ka -> 1 / 2 <= wa \/ wc <= 1 / 2) ->
  (kc <= 1 / 2 -> ka <= 1 / 2 -> wa <= 1 / 2 \/ 1 / 2 <= wc) ->
  G wa wb wc ka kb kc 1 0 (-1) <= 3 * (rho ka + rho kc).
Proof.
  intros wa wb wc ka kb kc Ha Hc H1 H2. rewrite !rho_m.
  assert (H : m ((4 * wa - 2) - (2 * kc - 1)) + m ((4 * wc - 2) + (2 * ka - 1)) + Rabs ((2 * kc - 1) + (2 * ka - 1))
    <= 3 * m (2 * kc - 1) + 3 * m (2 * ka - 1)).
  { apply core; lra. }
  replace ((4 * wc - 2) + (2 * ka - 1)) with ((4 * wc - 2) - (1 - 2 * ka)) in H by ring.
  rewrite (abs_m (4 * wa - 2) (2 * kc - 1)), (abs_m (4 * wc - 2) (1 - 2 * ka)) in H. unfold G.
  assert (E1 : Rabs (2 * wa * 1 + (kc * -1 - (kb - 1) * 0)) = Rabs ((4 * wa - 2) / 2 + 1 - (2 * kc - 1 + 1) / 2))
    by (apply f_equal; field).
  assert (E2 : Rabs (2 * (1 - wa) * 1 + (kb * 0 - (kc - 1) * -1)) = Rabs (1 - (4 * wa - 2) / 2 + (2 * kc - 1 - 1) / 2))
    by (apply f_equal; field).
  assert (E3 : Rabs (2 * kc - 1 + (2 * ka - 1)) = Rabs (2 * wb * 0 + (ka * 1 - (kc - 1) * -1)) + Rabs (2 * (1 - wb) * 0 + (kc * -1 - (ka - 1) * 1))).
  { replace (2 * wb * 0 + (ka * 1 - (kc - 1) * -1)) with (ka + kc - 1) by ring.
    replace (2 * (1 - wb) * 0 + (kc * -1 - (ka - 1) * 1)) with (- (ka + kc - 1)) by ring.
    rewrite Rabs_Ropp. replace (2 * kc - 1 + (2 * ka - 1)) with (2 * (ka + kc - 1)) by ring.
    rewrite Rabs_mult, (Rabs_right 2); lra. }
  assert (E4 : Rabs (2 * wc * -1 + (kb * 0 - (ka - 1) * 1)) = Rabs ((4 * wc - 2) / 2 + 1 - (1 - 2 * ka + 1) / 2)).
  { rewrite <- Rabs_Ropp. apply f_equal. field. }
  assert (E5 : Rabs (2 * (1 - wc) * -1 + (ka * 1 - (kb - 1) * 0)) = Rabs (1 - (4 * wc - 2) / 2 + (1 - 2 * ka - 1) / 2)).
  { rewrite <- Rabs_Ropp. apply f_equal. field. }
  rewrite E1, E2, E4, E5. lra.
Qed.

Section Slopes.
Variables ra rb rc : R.
Hypothesis Hab : ra <> rb.
Hypothesis Hbc : rb <> rc.
Hypothesis Hca : rc <> ra.

Definition w (r : R) := / (1 + r * r).
Definition k (r s : R) := s / (s - r).

Lemma w_range : forall r, 0 <= w r <= 1.
Proof.
  intros. unfold w. pose proof (Rle_0_sqr r) as H. unfold Rsqr in H. split.
  - left. apply Rinv_0_lt_compat. lra.
  - rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.

Lemma w_large : forall r, r * r <= 1 -> 1 / 2 <= w r.
Proof.
  intros. unfold w. pose proof (Rle_0_sqr r) as S. unfold Rsqr in S.
  replace (1 / 2) with (/ 2) by field. apply Rinv_le_contravar; lra.
Qed.

Lemma w_small : forall r, 1 <= r * r -> w r <= 1 / 2.
Proof.
  intros. unfold w. replace (1 / 2) with (/ 2) by field. apply Rinv_le_contravar; lra.
Qed.

Lemma k_square : forall r s, r <> s -> (2 * k r s - 1) * ((s - r) * (s - r)) = s * s - r * r.
Proof. intros. unfold k. field. lra. Qed.

Lemma k_large : forall r s, r <> s -> 1 / 2 <= k r s -> r * r <= s * s.
Proof.
  intros r s N H. pose proof (k_square r s N). pose proof (Rle_0_sqr (s - r)) as S. unfold Rsqr in S.
  assert (0 <= (2 * k r s - 1) * ((s - r) * (s - r))) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma k_small : forall r s, r <> s -> k r s <= 1 / 2 -> s * s <= r * r.
Proof.
  intros r s N H. pose proof (k_square r s N). pose proof (Rle_0_sqr (s - r)) as S. unfold Rsqr in S.
  assert (0 <= (1 - 2 * k r s) * ((s - r) * (s - r))) by (apply Rmult_le_pos; lra). lra.
Qed.

(* Of three slopes, the pair of the first and the last. *)
Lemma pair_of_slopes : forall p q r kb, p <> q -> q <> r ->
  G (w p) (w q) (w r) (k q r) kb (k p q) 1 0 (-1) <= 3 * (rho (k q r) + rho (k p q)).
Proof.
  intros p q r kb N M. apply pair; try apply w_range.
  - intros H1 H2. apply k_large in H1; auto. apply k_large in H2; auto.
    destruct (Rle_dec (q * q) 1).
    + left. apply w_large. lra.
    + right. apply w_small. lra.
  - intros H1 H2. apply k_small in H1; auto. apply k_small in H2; auto.
    destruct (Rle_dec (q * q) 1).
    + right. apply w_large. lra.
    + left. apply w_small. lra.
Qed.

Let g := G (w ra) (w rb) (w rc) (k rb rc) (k rc ra) (k ra rb).
Let pa := rho (k rb rc).
Let pb := rho (k rc ra).
Let pc := rho (k ra rb).

Lemma ac : g 1 0 (-1) <= 3 * (pa + pc).
Proof. apply pair_of_slopes; auto. Qed.

Lemma ba : g (-1) 1 0 <= 3 * (pb + pa).
Proof. unfold g. rewrite G_turn. apply pair_of_slopes; auto. Qed.

Lemma cb : g 0 (-1) 1 <= 3 * (pc + pb).
Proof. unfold g. rewrite G_turn, G_turn. apply pair_of_slopes; auto. Qed.

Lemma both : forall s t a b c a' b' c', g (s * a + t * a') (s * b + t * b') (s * c + t * c') <= Rabs s * g a b c + Rabs t * g a' b' c'.
Proof. intros. unfold g. rewrite <- !G_scale. apply G_sum. Qed.

Lemma tie : forall a b c, a + b + c = 0 -> g a b c <= 3 * (Rabs a * pa + Rabs b * pb + Rabs c * pc).
Proof.
  intros a b c H. pose proof ac as AC. pose proof ba as BA. pose proof cb as CB.
  assert (S : 0 <= a * b \/ 0 <= b * c \/ 0 <= a * c).
  { destruct (Rle_dec 0 a), (Rle_dec 0 b), (Rle_dec 0 c); nra. }
  destruct S as [S | [S | S]].
  - pose proof (both a (- b) 1 0 (-1) 0 (-1) 1) as B.
    replace (a * 1 + - b * 0) with a in B by ring. replace (a * 0 + - b * -1) with b in B by ring.
    replace (a * -1 + - b * 1) with c in B by lra. rewrite Rabs_Ropp in B.
    assert (C : Rabs c = Rabs a + Rabs b).
    { replace c with (- (a + b)) by lra. rewrite Rabs_Ropp. unfold Rabs; repeat (destruct (Rcase_abs _)); nra. }
    pose proof (Rabs_pos a). pose proof (Rabs_pos b). rewrite C. nra.
  - pose proof (both b (- c) (-1) 1 0 1 0 (-1)) as B.
    replace (b * -1 + - c * 1) with a in B by lra. replace (b * 1 + - c * 0) with b in B by ring.
    replace (b * 0 + - c * -1) with c in B by ring. rewrite Rabs_Ropp in B.
    assert (C : Rabs a = Rabs b + Rabs c).
    { replace a with (- (b + c)) by lra. rewrite Rabs_Ropp. unfold Rabs; repeat (destruct (Rcase_abs _)); nra. }
    pose proof (Rabs_pos c). pose proof (Rabs_pos b). rewrite C. nra.
  - pose proof (both c (- a) 0 (-1) 1 (-1) 1 0) as B.
    replace (c * 0 + - a * -1) with a in B by ring. replace (c * -1 + - a * 1) with b in B by lra.
    replace (c * 1 + - a * 0) with c in B by ring. rewrite Rabs_Ropp in B.
    assert (C : Rabs b = Rabs a + Rabs c).
    { replace b with (- (a + c)) by lra. rewrite Rabs_Ropp. unfold Rabs; repeat (destruct (Rcase_abs _)); nra. }
    pose proof (Rabs_pos a). pose proof (Rabs_pos c). rewrite C. nra.
Qed.

Lemma one_a : forall t, g t 0 0 = Rabs t * (2 + 2 * pa).
Proof.
  clear Hab Hbc Hca. intros. pose proof (w_range ra). replace t with (t * 1) at 1 by ring.
  replace (g (t * 1) 0 0) with (g (t * 1) (t * 0) (t * 0)) by (f_equal; ring). unfold g. rewrite G_scale. f_equal.
  unfold G, pa, rho.
  replace (2 * w ra * 1 + (k ra rb * 0 - (k rc ra - 1) * 0)) with (2 * w ra) by ring.
  replace (2 * (1 - w ra) * 1 + (k rc ra * 0 - (k ra rb - 1) * 0)) with (2 * (1 - w ra)) by ring.
  replace (2 * w rb * 0 + (k rb rc * 1 - (k ra rb - 1) * 0)) with (k rb rc) by ring.
  replace (2 * (1 - w rb) * 0 + (k ra rb * 0 - (k rb rc - 1) * 1)) with (- (k rb rc - 1)) by ring.
  replace (2 * w rc * 0 + (k rc ra * 0 - (k rb rc - 1) * 1)) with (- (k rb rc - 1)) by ring.
  replace (2 * (1 - w rc) * 0 + (k rb rc * 1 - (k rc ra - 1) * 0)) with (k rb rc) by ring.
  rewrite !Rabs_Ropp. rewrite (Rabs_right (2 * w ra)), (Rabs_right (2 * (1 - w ra))); lra.
Qed.
End Slopes.

(* The other rows, by turning the names. *)
Definition turned (ra rb rc a b c : R) := G (w ra) (w rb) (w rc) (k rb rc) (k rc ra) (k ra rb) a b c.

Lemma turned_turn : forall ra rb rc a b c, turned ra rb rc a b c = turned rb rc ra b c a.
Proof. intros. unfold turned. apply G_turn. Qed.

Lemma sum_turned : forall ra rb rc a b c a' b' c',
  turned ra rb rc (a + a') (b + b') (c + c') <= turned ra rb rc a b c + turned ra rb rc a' b' c'.
Proof. intros. unfold turned. apply G_sum. Qed.

(* If the determinant is not zero, one minor takes it. *)
Lemma beside : forall ra rb rc a b c, ra <> rb -> rb <> rc -> rc <> ra ->
  rho (k rb rc) <= 2 ->
  turned ra rb rc a b c <= 3 * (Rabs a * rho (k rb rc) + Rabs b * rho (k rc ra) + Rabs c * rho (k ra rb)) + 14 * Rabs (a + b + c).
Proof.
  intros ra rb rc a b c N1 N2 N3 H.
  pose proof (sum_turned ra rb rc (a - (a + b + c)) b c (a + b + c) 0 0) as S.
  replace (a - (a + b + c) + (a + b + c)) with a in S by ring. rewrite !Rplus_0_r in S.
  pose proof (one_a ra rb rc (a + b + c)) as O.
  pose proof (tie ra rb rc N1 N2 N3 (a - (a + b + c)) b c ltac:(ring)) as T.
  unfold turned in *. rewrite O in S.
  assert (A : Rabs (a - (a + b + c)) <= Rabs a + Rabs (a + b + c)).
  { pose proof (Rabs_triang a (- (a + b + c))) as Q. rewrite Rabs_Ropp in Q. exact Q. }
  pose proof (Rabs_pos (a + b + c)) as D. set (d := Rabs (a + b + c)) in *.
  assert (R0 : 0 <= rho (k rb rc)) by (unfold rho; pose proof (Rabs_pos (k rb rc)); pose proof (Rabs_pos (k rb rc - 1)); lra).
  assert (M1 : Rabs (a - (a + b + c)) * rho (k rb rc) <= Rabs a * rho (k rb rc) + d * 2).
  { apply Rle_trans with ((Rabs a + d) * rho (k rb rc)). apply Rmult_le_compat_r; assumption.
    rewrite Rmult_plus_distr_r. apply Rplus_le_compat_l. apply Rmult_le_compat_l; assumption. }
  assert (M2 : d * (2 + 2 * rho (k rb rc)) <= d * 6) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

Lemma far : forall ra rb rc a b c,
  2 <= rho (k rb rc) -> 2 <= rho (k rc ra) -> 2 <= rho (k ra rb) ->
  turned ra rb rc a b c <= 3 * (Rabs a * rho (k rb rc) + Rabs b * rho (k rc ra) + Rabs c * rho (k ra rb)).
Proof.
  intros ra rb rc a b c Ha Hb Hc.
  pose proof (sum_turned ra rb rc a 0 0 0 b c) as S1. pose proof (sum_turned ra rb rc 0 b 0 0 0 c) as S2.
  rewrite !Rplus_0_r, !Rplus_0_l in S1. rewrite !Rplus_0_r, !Rplus_0_l in S2.
  pose proof (one_a ra rb rc a) as Oa.
  pose proof (one_a rb rc ra b) as Ob. pose proof (one_a rc ra rb c) as Oc.
  assert (Tb : turned ra rb rc 0 b 0 = turned rb rc ra b 0 0) by apply turned_turn.
  assert (Tc : turned ra rb rc 0 0 c = turned rc ra rb c 0 0) by (rewrite turned_turn; apply turned_turn).
  unfold turned in *. rewrite Oa in S1. rewrite Tb, Tc, Ob, Oc in S2.
  pose proof (Rmult_le_compat_l (Rabs a) _ _ (Rabs_pos a) Ha).
  pose proof (Rmult_le_compat_l (Rabs b) _ _ (Rabs_pos b) Hb).
  pose proof (Rmult_le_compat_l (Rabs c) _ _ (Rabs_pos c) Hc).
  lra.
Qed.

Lemma of_slopes : forall ra rb rc a b c, ra <> rb -> rb <> rc -> rc <> ra ->
  turned ra rb rc a b c <= 3 * (Rabs a * rho (k rb rc) + Rabs b * rho (k rc ra) + Rabs c * rho (k ra rb)) + 14 * Rabs (a + b + c).
Proof.
  intros ra rb rc a b c N1 N2 N3. pose proof (Rabs_pos (a + b + c)).
  destruct (Rle_dec (rho (k rb rc)) 2). { apply beside; auto. }
  destruct (Rle_dec (rho (k rc ra)) 2).
  { rewrite turned_turn. replace (a + b + c) with (b + c + a) by ring.
    pose proof (beside rb rc ra b c a N2 N3 N1 r). lra. }
  destruct (Rle_dec (rho (k ra rb)) 2).
  { rewrite turned_turn, turned_turn. replace (a + b + c) with (c + a + b) by ring.
    pose proof (beside rc ra rb c a b N3 N1 N2 r). lra. }
  pose proof (far ra rb rc a b c ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(* The lemma, in the coordinates of three differences. D is the determinant of the rows (x, y, x^2 + y^2); the left side is
   the sum of |e dD/de| over the six coordinates e; the permanent takes every product by magnitude. *)
Theorem incircle_differences : forall xa ya xb yb xc yc : R,
  xa <> 0 -> xb <> 0 -> xc <> 0 ->
  xb * yc - xc * yb <> 0 -> xc * ya - xa * yc <> 0 -> xa * yb - xb * ya <> 0 ->
  let la := xa * xa + ya * ya in let lb := xb * xb + yb * yb in let lc := xc * xc + yc * yc in
  let D := la * (xb * yc - xc * yb) + lb * (xc * ya - xa * yc) + lc * (xa * yb - xb * ya) in
  Rabs (xa * (2 * xa * (xb * yc - xc * yb) - lb * yc + lc * yb)) +
  Rabs (ya * (2 * ya * (xb * yc - xc * yb) + lb * xc - lc * xb)) +
  (Rabs (xb * (2 * xb * (xc * ya - xa * yc) - lc * ya + la * yc)) +
   Rabs (yb * (2 * yb * (xc * ya - xa * yc) + lc * xa - la * xc))) +
  (Rabs (xc * (2 * xc * (xa * yb - xb * ya) - la * yb + lb * ya)) +
   Rabs (yc * (2 * yc * (xa * yb - xb * ya) + la * xb - lb * xa)))
  <= 3 * (la * (Rabs (xb * yc) + Rabs (xc * yb)) + lb * (Rabs (xc * ya) + Rabs (xa * yc)) + lc * (Rabs (xa * yb) + Rabs (xb * ya)))
     + 14 * Rabs D.
Proof.
  intros xa ya xb yb xc yc Nxa Nxb Nxc Na Nb Nc la lb lc D.
  assert (Sa : 0 < la). { unfold la. pose proof (Rsqr_pos_lt xa Nxa). pose proof (Rle_0_sqr ya). unfold Rsqr in *. lra. }
  assert (Sb : 0 < lb). { unfold lb. pose proof (Rsqr_pos_lt xb Nxb). pose proof (Rle_0_sqr yb). unfold Rsqr in *. lra. }
  assert (Sc : 0 < lc). { unfold lc. pose proof (Rsqr_pos_lt xc Nxc). pose proof (Rle_0_sqr yc). unfold Rsqr in *. lra. }
  set (ra := ya / xa). set (rb := yb / xb). set (rc := yc / xc).
  set (a := la * (xb * yc - xc * yb)). set (b := lb * (xc * ya - xa * yc)). set (c := lc * (xa * yb - xb * ya)).
  assert (Dbc : rc - rb <> 0).
  { replace (rc - rb) with ((xb * yc - xc * yb) / (xb * xc)) by (unfold rc, rb; field; auto).
    unfold Rdiv. apply Rmult_integral_contrapositive_currified; auto. apply Rinv_neq_0_compat.
    apply Rmult_integral_contrapositive_currified; auto. }
  assert (Dca : ra - rc <> 0).
  { replace (ra - rc) with ((xc * ya - xa * yc) / (xa * xc)) by (unfold rc, ra; field; auto).
    unfold Rdiv. apply Rmult_integral_contrapositive_currified; auto. apply Rinv_neq_0_compat.
    apply Rmult_integral_contrapositive_currified; auto. }
  assert (Dab : rb - ra <> 0).
  { replace (rb - ra) with ((xa * yb - xb * ya) / (xb * xa)) by (unfold rb, ra; field; auto).
    unfold Rdiv. apply Rmult_integral_contrapositive_currified; auto. apply Rinv_neq_0_compat.
    apply Rmult_integral_contrapositive_currified; auto. }
  assert (Ka : k rb rc = xb * yc / (xb * yc - xc * yb)) by (unfold k, rb, rc; field; repeat split; auto).
  assert (Kb : k rc ra = xc * ya / (xc * ya - xa * yc)) by (unfold k, ra, rc; field; repeat split; auto).
  assert (Kc : k ra rb = xa * yb / (xa * yb - xb * ya)) by (unfold k, ra, rb; field; repeat split; auto).
  assert (Wa : w ra = xa * xa / la). { unfold w, ra, la in *. field. split; auto. lra. }
  assert (Wb : w rb = xb * xb / lb). { unfold w, rb, lb in *. field. split; auto. lra. }
  assert (Wc : w rc = xc * xc / lc). { unfold w, rc, lc in *. field. split; auto. lra. }
  pose proof (of_slopes ra rb rc a b c ltac:(lra) ltac:(lra) ltac:(lra)) as H.
  unfold turned, G, rho in H. rewrite Ka, Kb, Kc, Wa, Wb, Wc in H.
  assert (L : forall l d p, 0 < l -> d <> 0 -> Rabs (l * d) * (Rabs (p / d) + Rabs (p / d - 1)) = l * (Rabs p + Rabs (p - d))).
  { intros l d p Hl Hd. rewrite Rabs_mult, (Rabs_right l) by lra. rewrite Rmult_assoc. f_equal.
    rewrite Rmult_plus_distr_l, <- !Rabs_mult. f_equal; apply f_equal; field; auto. }
  unfold a, b, c in H. rewrite !L in H by assumption.
  replace (xb * yc - (xb * yc - xc * yb)) with (xc * yb) in H by ring.
  replace (xc * ya - (xc * ya - xa * yc)) with (xa * yc) in H by ring.
  replace (xa * yb - (xa * yb - xb * ya)) with (xb * ya) in H by ring.
  fold D in H.
  match type of H with ?x1 + ?x2 + (?x3 + ?x4) + (?x5 + ?x6) <= _ =>
    match goal with |- ?y1 + ?y2 + (?y3 + ?y4) + (?y5 + ?y6) <= _ =>
      replace y1 with x1; [replace y2 with x2; [replace y3 with x3; [replace y4 with x4; [replace y5 with x5; [replace y6 with x6; [exact H |] |] |] |] |] |]
    end
  end; apply f_equal; unfold la, lb, lc in *; field; repeat split; auto; lra.
Qed.

Print Assumptions incircle_differences.
