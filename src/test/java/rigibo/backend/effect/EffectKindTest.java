package rigibo.backend.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Effect.Kind;

import java.util.Arrays;
import java.util.List;

/** The kinds of effects agree with the records. */
class EffectKindTest {

    private static Class<?> record(Kind kind) {
        return Arrays.stream(Effect.class.getPermittedSubclasses())
                .filter(type -> type.getSimpleName().equals(kind.typeName()))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void eachRecordHasAKind() {
        assertThat(Effect.class.getPermittedSubclasses()).hasSameSizeAs(Kind.values());
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "FIELD")
    void numbersOfAnEffectMakeItAgain(Kind kind) {
        boolean isList =
                Arrays.stream(record(kind).getRecordComponents())
                        .anyMatch(part -> part.getType() == List.class);
        double[] numbers = new double[isList ? 60 : kind.numbers()];
        Arrays.setAll(numbers, i -> i % 5 == 4 ? 3 : 1 + i / 8.0);
        Effect made = kind.of(numbers);
        assertThat(made).isInstanceOf(record(kind));
        assertThat(made.kind()).isEqualTo(kind);
        assertThat(made.numbers()).containsExactly(numbers);
    }

    @ParameterizedTest
    @EnumSource
    void sevenNumbersMakeNone(Kind kind) {
        assertThatIllegalArgumentException().isThrownBy(() -> kind.of(new double[7]));
    }

    @Test
    void namesAreThoseOfLevelFilesAndClasses() {
        assertThat(new RollingResistance().title()).isEqualTo("rolling-resistance");
        assertThat(Kind.ROLLING_RESISTANCE.typeName()).isEqualTo("RollingResistance");
    }
}
