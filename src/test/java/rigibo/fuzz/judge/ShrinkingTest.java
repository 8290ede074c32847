package rigibo.fuzz.judge;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.fuzz.program.Operation;
import rigibo.fuzz.program.Operation.Kind;
import rigibo.fuzz.program.Program;
import rigibo.fuzz.program.Programs;

import java.util.ArrayList;
import java.util.List;

/** A defect that is planted in a program is found, told, and all that is left of the program. */
class ShrinkingTest {

    private static final Operation DEFECT =
            new Operation(
                    "pool.crash();",
                    Kind.DONE,
                    "",
                    List.of(),
                    stage -> {
                        throw new ArrayIndexOutOfBoundsException(stage.added());
                    });

    private static Program planted() {
        Program program = Programs.of(1, 0);
        List<Operation> operations = new ArrayList<>(program.operations());
        operations.add(operations.size() / 2, DEFECT);
        return program.with(operations);
    }

    @Test
    void crashIsFoundWhereItHappens() {
        Program program = planted();
        Failure failure = new Judge(new Tally(), new Watch()).judge(program).orElseThrow();
        assertThat(program.operations().get(failure.operation())).isSameAs(DEFECT);
        assertThat(failure.words()).contains("ArrayIndexOutOfBoundsException");
    }

    @Test
    void onlyTheDefectIsLeft() {
        Watch watch = new Watch();
        Failure failure = new Judge(new Tally(), watch).judge(planted()).orElseThrow();
        Program small = new Shrinking(watch).of(planted(), failure);
        assertThat(small.operations()).containsExactly(DEFECT);
        assertThat(small.java()).contains("new Pool(").endsWith("pool.crash();");
    }

    @Test
    void refusalThatDoesNotComeIsFound() {
        Operation forgotten =
                Operation.refused("pool.time();", "Pool.time", List.of(), stage -> stage.added());
        Program program = Programs.of(1, 0).with(List.of(forgotten));
        assertThat(new Judge(new Tally(), new Watch()).judge(program)).isPresent();
    }
}
