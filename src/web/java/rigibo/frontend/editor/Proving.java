package rigibo.frontend.editor;

import rigibo.frontend.document.Fault;
import rigibo.frontend.document.Place;
import rigibo.frontend.document.Problem;
import rigibo.frontend.editor.desk.Inspection;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.puzzle.check.LevelProof;
import rigibo.web.aside.Aside;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Plays drafts to their end on a thread beside the page, which goes on meanwhile. */
public final class Proving {

    /** Name of the errand; its only word is the draft. */
    public static final String ERRAND = "proving";

    private static final String NAME = "draft";
    private static final String GAMES = "games";
    private static final String FOUND = "found";

    /** Number of words for a problem. */
    private static final int WORDS = 7;

    /** Separator of the values of a problem, which none of them contains. */
    private static final String APART = "\n";

    private Optional<Aside> aside = Optional.empty();
    private Optional<List<Problem>> found = Optional.empty();
    private Draft draft;
    private long games;

    void start(Draft proved) {
        if (!isBusy()) {
            draft = proved;
            games = 0;
            found = Optional.empty();
            aside = Optional.of(Aside.begin(ERRAND, List.of(proved.toString()), this::told));
        }
    }

    /** Plays a draft and reports the findings to the page; called by the thread beside it. */
    public static void prove(String text) {
        List<String> words = new ArrayList<>(List.of(FOUND));
        LevelProof.problems(NAME, text, games -> Aside.tell(List.of(GAMES, String.valueOf(games))))
                .forEach(problem -> words.addAll(words(problem)));
        Aside.tell(words);
    }

    private static List<String> words(Problem problem) {
        return List.of(
                problem.severity().name(),
                String.valueOf(problem.place().line()),
                String.valueOf(problem.place().column()),
                problem.pointer(),
                problem.message(),
                problem.fault().kind(),
                String.join(APART, problem.fault().values()));
    }

    private static Problem problem(List<String> words) {
        return new Problem(
                Problem.Severity.valueOf(words.get(0)),
                NAME,
                new Place(Integer.parseInt(words.get(1)), Integer.parseInt(words.get(2))),
                words.get(3),
                new Fault(words.get(5), words.get(4), List.of(words.get(6).split(APART))));
    }

    private void told(List<String> words) {
        if (!words.isEmpty() && words.get(0).equals(GAMES)) {
            games = Long.parseLong(words.get(1));
            return;
        }
        close();
        // A thread that failed has no findings.
        if (!words.isEmpty()) {
            List<Problem> problems = new ArrayList<>();
            for (int at = 1; at < words.size(); at += WORDS) {
                problems.add(problem(words.subList(at, at + WORDS)));
            }
            found = Optional.of(problems);
        }
    }

    boolean isBusy() {
        return aside.isPresent();
    }

    /** Games played for the present proof, or the last one. */
    long games() {
        return games;
    }

    /** Passes the findings on as soon as there are any; returns whether there were. */
    boolean tell(Inspection inspection) {
        boolean isDone = found.isPresent();
        found.ifPresent(problems -> inspection.played(draft, problems));
        found = Optional.empty();
        return isDone;
    }

    void close() {
        aside.ifPresent(Aside::stop);
        aside = Optional.empty();
    }
}
