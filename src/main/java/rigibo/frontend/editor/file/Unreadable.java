package rigibo.frontend.editor.file;

import rigibo.frontend.document.Cause;
import rigibo.frontend.document.Fault;
import rigibo.frontend.document.Problem;

import java.io.IOException;

/** A file or code is not a draft. Its problem is told to authors in their language. */
public final class Unreadable extends IOException {

    private static final long serialVersionUID = 1;

    private final transient Problem problem;
    private final boolean isSetAside;

    private Unreadable(Problem problem, boolean isSetAside) {
        super(problem.toString());
        this.problem = problem;
        this.isSetAside = isSetAside;
    }

    /** A file or code that stays where it is. */
    Unreadable(Problem problem) {
        this(problem, false);
    }

    /** A file that was given another name, so that it does not stand in the way again. */
    static Unreadable setAside(Problem problem) {
        return new Unreadable(problem, true);
    }

    /** A file or code of a name that is none for some cause. */
    static Unreadable of(String name, Cause cause, Fault fault) {
        return new Unreadable(Problem.ofWhole(name, cause, fault));
    }

    /** Whether the file was given another name. */
    public boolean isSetAside() {
        return isSetAside;
    }

    /** Why it cannot be read. */
    public Problem problem() {
        return problem;
    }
}
