package rigibo.web.build;

import org.teavm.diagnostics.DefaultProblemTextConsumer;
import org.teavm.diagnostics.Problem;
import org.teavm.diagnostics.ProblemProvider;
import org.teavm.model.CallLocation;

import java.util.stream.Collectors;

/** The compiler's problems with missing classes and methods, as text. */
final class Problems {

    private Problems() {}

    /** A line for each problem; empty if there is none. */
    static String of(ProblemProvider provider) {
        return provider.getProblems().stream()
                .map(Problems::line)
                .collect(Collectors.joining("\n"));
    }

    private static String line(Problem problem) {
        DefaultProblemTextConsumer words = new DefaultProblemTextConsumer();
        problem.render(words);
        CallLocation place = problem.getLocation();
        return words.getText() + (place == null ? "" : " (" + place.getMethod() + ")");
    }
}
