package rigibo.frontend.editor;

import rigibo.frontend.document.ShareCode;
import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.desk.Inspection;
import rigibo.frontend.editor.desk.Typing;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Joinery;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.draft.Prize;
import rigibo.frontend.editor.draft.Settled;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.editor.pane.Craft;
import rigibo.frontend.editor.pane.ListPane;
import rigibo.frontend.editor.tool.BallTool;
import rigibo.frontend.editor.tool.CornersTool;
import rigibo.frontend.editor.tool.DrawTool;
import rigibo.frontend.editor.tool.GlueTool;
import rigibo.frontend.editor.tool.JointTool;
import rigibo.frontend.editor.tool.SelectTool;
import rigibo.frontend.editor.tool.Stencil;
import rigibo.frontend.editor.tool.Tool;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** All actions of an author, for keys and buttons alike. */
final class Workshop {

    private final Director director;
    private final Desk desk;
    private final View view;
    private final Typing typing = new Typing();
    private final Inspection inspection = new Inspection();
    private final Proving proving = new Proving();
    private final Drawer drawer;
    private Craft craft = Craft.SELECT;
    private Tool tool;
    private Optional<TestRun> test = Optional.empty();
    private Optional<Solution> won = Optional.empty();
    private Optional<Settling> settling = Optional.empty();
    private Optional<ListPane> list = Optional.empty();
    private final Remark remark;

    Workshop(Director director, DraftFile first) {
        this.director = director;
        remark = new Remark(director.words());
        drawer = new Drawer(director.levels(), first);
        desk = new Desk(first.draft(), View.camera(first.draft()));
        view = new View(desk);
        tool = new SelectTool(desk);
        drawer.trouble().ifPresent(remark::trouble);
    }

    Desk desk() {
        return desk;
    }

    View view() {
        return view;
    }

    Typing typing() {
        return typing;
    }

    Inspection inspection() {
        return inspection;
    }

    Drawer drawer() {
        return drawer;
    }

    Words words() {
        return director.words();
    }

    Tool tool() {
        return tool;
    }

    Craft craft() {
        return craft;
    }

    Optional<TestRun> test() {
        return test;
    }

    Optional<Solution> won() {
        return won;
    }

    Optional<ListPane> list() {
        return list;
    }

    /** A sentence about what was done last, or about how far a proof is. */
    String remark() {
        return isProving() && remark.text().isEmpty()
                ? words().of("editor.proving", proving.games())
                : remark.text();
    }

    boolean isProving() {
        return proving.isBusy();
    }

    void take(Craft next) {
        tool.cancelled();
        craft = next;
        tool =
                switch (next) {
                    case SELECT -> new SelectTool(desk);
                    case BOX -> new DrawTool(desk, Stencil.BOX);
                    case DISC -> new DrawTool(desk, Stencil.DISC);
                    case CORNERS -> new CornersTool(desk, CornersTool.Kind.POLYGON);
                    case LANDSCAPE -> new CornersTool(desk, CornersTool.Kind.LANDSCAPE);
                    case CAPSULE -> new DrawTool(desk, Stencil.CAPSULE);
                    case GLUE -> new GlueTool(desk);
                    case REGULAR -> new DrawTool(desk, Stencil.REGULAR);
                    case BALL -> new BallTool(desk);
                    case HINGE, WELD, WHEEL, SLIDE, ROD, ROPE, SPRING ->
                            new JointTool(desk, next.joint().orElseThrow());
                };
    }

    /** Makes one turn: checks the draft if it changed, and takes over what playing it found. */
    void turn() {
        settling.ifPresent(this::goOn);
        if (!desk.history().isGesture()) {
            inspection.look(desk.draft());
        }
        if (proving.tell(inspection)) {
            remark.say("checked", inspection.findings().size());
        }
        if (test.filter(TestRun::isLeft).isPresent()) {
            endTest();
        }
    }

    /** Plays the draft, or shows why it cannot be played. */
    void startTest() {
        typing.end();
        inspection.look(desk.draft());
        Optional<Level> level = inspection.level();
        if (level.isPresent()) {
            won = Optional.empty();
            test = Optional.of(new TestRun(director, level.get()));
            remark.clear();
        } else {
            remark.sayErrors("untestable", inspection.errors(), desk.isInHand());
        }
    }

    /** Returns to the draft as it was left. */
    void endTest() {
        won = test.flatMap(TestRun::solution);
        test.ifPresent(run -> run.scene().closed());
        test = Optional.empty();
    }

    void keepSolution() {
        won.ifPresent(desk::keep);
        won.ifPresent(solution -> remark.say("kept", solution.clicks().size()));
        won = Optional.empty();
    }

    /** Proves the star by the clicks that won; a check tells whether they earn it. */
    void keepForStar() {
        won.ifPresent(solution -> desk.change(Prize.proved(desk.draft(), solution)));
        won = Optional.empty();
        remark.say("kept.star");
    }

    /** Plays the draft in all the ways that {@code levels check} does. */
    void check() {
        typing.end();
        inspection.look(desk.draft());
        if (inspection.level().isPresent()) {
            proving.start(desk.draft());
            remark.clear();
        } else {
            remark.sayErrors("unplayable", inspection.errors(), desk.isInHand());
        }
    }

    /** Lets everything fall and swing until it rests, and begins the level there. */
    void settle() {
        typing.end();
        tool.cancelled();
        LoadedLevel loose =
                new LevelLoader().parse("draft", Settled.loose(desk.draft()).toString());
        settling = loose.level().map(level -> new Settling(desk, level));
        if (settling.isPresent()) {
            remark.say("settling");
        } else {
            remark.sayErrors("unsettled", loose.errors(), desk.isInHand());
        }
    }

    private void goOn(Settling running) {
        Settling.State state = running.turn();
        if (state == Settling.State.MOVING) {
            return;
        }
        settling = Optional.empty();
        if (state == Settling.State.RESTED) {
            remark.say(hasSoftJoints() ? "settled.soft" : "settled");
        } else {
            desk.choose(running.culprit());
            String name = desk.item().map(Joinery::name).orElse("");
            remark.say(state == Settling.State.LOST ? "settle.lost" : "settle.restless", name);
        }
    }

    /** Springs that pull back to where a level begins give way anew from each start. */
    private boolean hasSoftJoints() {
        return JointEntry.all(desk.draft()).stream()
                .anyMatch(
                        joint ->
                                joint.type() != LevelJoint.Type.SPRING
                                        && joint.node().has("spring"));
    }

    /** Stops settling, which leaves the draft as it was; returns whether there was any. */
    boolean stopSettling() {
        boolean isOn = settling.isPresent();
        if (isOn) {
            settling.get().cancel();
            settling = Optional.empty();
            remark.say("settle.stopped");
        }
        return isOn;
    }

    void forgetSolution() {
        won = Optional.empty();
    }

    void undo() {
        typing.cancel();
        desk.history().undo();
    }

    void redo() {
        typing.cancel();
        desk.history().redo();
    }

    void save() {
        typing.end();
        try {
            DraftFile saved = drawer.save(desk.draft());
            if (!saved.draft().equals(desk.draft())) {
                desk.change(saved.draft());
            }
            inspection.look(desk.draft());
            String file = saved.file().map(Path::toString).orElse("");
            if (inspection.errors() > 0) {
                remark.say("saved.errors", file, inspection.errors());
            } else {
                remark.say("saved", file);
            }
        } catch (IOException refused) {
            remark.trouble(refused);
        }
    }

    /** Begins another level; unsaved changes are kept for later. */
    void begin(DraftFile other) {
        stopSettling();
        typing.cancel();
        drawer.put(desk.draft()).ifPresent(remark::trouble);
        drawer.take(other);
        desk.lay(other.draft());
        view.home();
        won = Optional.empty();
        list = Optional.empty();
        take(Craft.SELECT);
    }

    void beginNew() {
        begin(new DraftFile(NewLevel.draft(), Optional.empty()));
        remark.clear();
    }

    /** Opens the draft that was left unsaved, in place of this one. */
    void takeUp() {
        Draft present = desk.draft();
        drawer.offered()
                .ifPresent(
                        left -> {
                            drawer.put(present).ifPresent(remark::trouble);
                            drawer.takeUp();
                            desk.lay(left.left().draft());
                            view.home();
                        });
    }

    /** Discards the draft that was left unsaved. */
    void refuse() {
        drawer.refuse().ifPresent(remark::trouble);
    }

    void showFiles() {
        typing.end();
        try {
            List<ListPane.Choice> choices = new ArrayList<>();
            for (Path file : drawer.files()) {
                choices.add(new ListPane.Choice(file.getFileName().toString(), () -> open(file)));
            }
            String heading = words().of("editor.open.heading");
            list = Optional.of(new ListPane(heading, choices, this::closeList));
        } catch (IOException unreadable) {
            remark.trouble(unreadable);
        }
    }

    private void open(Path file) {
        try {
            begin(DraftFiles.open(file));
            remark.say("opened", file.toString());
        } catch (IOException unreadable) {
            remark.trouble(unreadable);
        }
    }

    /** Puts the draft on the clipboard, as a code. */
    void copyCode() {
        typing.end();
        remark.clear();
        Optional<String> code = ShareCode.of(ShareCode.Kind.LEVEL, desk.draft().document());
        code.ifPresentOrElse(director::copy, () -> remark.say("too-long"));
    }

    boolean handsOver() {
        return director.handsOver();
    }

    /** Hands the level over as a file. */
    void handOver() {
        typing.end();
        director.handOver(DraftFiles.nameOf(desk.draft()), desk.draft().toString());
    }

    /** Asks for a code that was copied elsewhere; it comes by {@link #paste}. */
    void askForCode() {
        director.paste();
    }

    /** Opens the level of a code; a text goes to the field that is typed into. */
    void paste(String text) {
        if (typing.isOn()) {
            text.codePoints().forEach(typing::typed);
            return;
        }
        try {
            begin(DraftFiles.ofCode(text));
            remark.say("pasted");
        } catch (IOException unreadable) {
            remark.trouble(unreadable);
        }
    }

    void closeList() {
        list = Optional.empty();
    }

    /** Leaves the scene; unsaved changes are kept. */
    void close() {
        stopSettling();
        typing.end();
        test.ifPresent(run -> run.scene().closed());
        drawer.put(desk.draft());
        proving.close();
    }
}
