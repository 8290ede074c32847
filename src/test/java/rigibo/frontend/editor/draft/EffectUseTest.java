package rigibo.frontend.editor.draft;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class EffectUseTest {

    private final Draft draft = NewLevel.draft();

    @Test
    void aBeltDeclaresSurfaceSpeedAndItsEndTakesItBack() {
        Draft belt = draft.with("/bodies/0/surfaceSpeed", Decimal.of(2));
        Draft declared = EffectUse.followed(draft, belt);
        assertThat(EffectUse.declared(declared)).contains("surface-speed");
        Draft still = EffectUse.followed(declared, declared.without("/bodies/0/surfaceSpeed"));
        assertThat(EffectUse.declared(still)).isEqualTo(EffectUse.declared(draft));
    }

    @Test
    void aWorldWithoutGravityDeclaresNone() {
        Draft weightless = draft.with("/world/gravity/1", Decimal.of(0));
        assertThat(EffectUse.declared(EffectUse.followed(draft, weightless)))
                .doesNotContain("gravity");
    }

    @Test
    void whatTheAuthorChoseStaysWhereItsUseDoesNotChange() {
        Draft chosen = EffectUse.switched(draft, "rolling-resistance");
        Draft moved = chosen.with("/ball/x", Decimal.of(3));
        assertThat(EffectUse.followed(chosen, moved)).isEqualTo(moved);
    }
}
