package rigibo.fuzz.program;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effect;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;

import java.util.HashSet;
import java.util.Set;

class ProgramsTest {

    private static final int PROGRAMS = 200;

    @Test
    void sameSeedAndIndexDrawTheSameProgram() {
        for (int index = 0; index < PROGRAMS; index++) {
            assertThat(Programs.of(3, index).java()).isEqualTo(Programs.of(3, index).java());
        }
        assertThat(Programs.of(3, 0).java())
                .isNotEqualTo(Programs.of(3, 1).java())
                .isNotEqualTo(Programs.of(4, 0).java());
    }

    @Test
    void everyEffectAndEveryKindOfOperationIsDrawn() {
        Set<String> effects = new HashSet<>();
        Set<Operation.Kind> kinds = new HashSet<>();
        for (int index = 0; index < PROGRAMS; index++) {
            Program program = Programs.of(1, index);
            program.effects().value().all().forEach(effect -> effects.add(effect.title()));
            program.operations().forEach(operation -> kinds.add(operation.kind()));
        }
        assertThat(effects).hasSize(Effect.class.getPermittedSubclasses().length);
        assertThat(kinds).containsExactlyInAnyOrder(Operation.Kind.values());
    }

    /** Otherwise nothing behind the checksum would ever be asked. */
    @Test
    void alterationsSealASnapshotAsTheEngineDoes() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.dynamic(new Circle(1)).name("b0"));
        byte[] snapshot = pool.snapshot();
        assertThat(Alteration.sealed(snapshot.clone())).isEqualTo(snapshot);
    }

    @Test
    void leftOutAdditionsLeaveOutWhatNamesTheBody() {
        Program program = Programs.of(1, 0);
        Stage stage = program.stage(Witness.NONE);
        program.operations().stream()
                .filter(operation -> !operation.bodies().isEmpty())
                .forEach(operation -> assertThat(operation.canBeDone(stage)).isFalse());
    }
}
