package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.endless.Day;
import rigibo.frontend.puzzle.endless.Making;
import rigibo.frontend.puzzle.endless.MakingNote;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.replay.LoadedReplay;
import rigibo.frontend.puzzle.replay.UnmadeReplay;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.TiledScene;
import rigibo.frontend.scene.widget.Tiles;

import java.util.List;

/** Waits until the level of a replay is made, and then shows the replay. */
final class MadeReplayScene implements TiledScene {

    private final Director director;
    private final Words words;
    private final UnmadeReplay replay;
    private final Making making;
    private MadePlaces places = MadePlaces.ON_A_DESK;
    private Tiles tiles;
    private int steps;
    private boolean isHandedOver;

    /** Begins to make the level. */
    MadeReplayScene(Director director, UnmadeReplay replay) {
        this(director, replay, Making.begin(List.of(replay.origin().seed())));
    }

    MadeReplayScene(Director director, UnmadeReplay replay, Making making) {
        this.director = director;
        this.replay = replay;
        this.making = making;
        words = director.words();
        layOut();
    }

    private void layOut() {
        tiles = new Tiles(List.of(MadeLevelScene.wayBack(director, places)), Tiles.NONE);
    }

    @Override
    public String title() {
        return "RigiBo – " + words.of("made.replay");
    }

    @Override
    public void step() {
        steps++;
        MadeLevelScene.chooseWayBack(tiles, making);
        if (!isHandedOver && making.made().isPresent()) {
            isHandedOver = true;
            director.show(watched(making.made().get().level()));
        }
    }

    private Scene watched(Level level) {
        Level named =
                Day.ofSeed(replay.origin().seed())
                        .map(day -> day.named(level, words))
                        .orElse(level);
        LoadedReplay loaded = replay.in(named);
        return loaded.recording()
                .<Scene>map(run -> new ReplayScene(director, run, ReplayScene.Audience.PLAYER))
                .orElseGet(() -> new ProblemsScene(director, loaded.problems()));
    }

    @Override
    public void draw(Canvas canvas) {
        MadePlaces fitting = MadePlaces.of(canvas.layout());
        if (!fitting.equals(places)) {
            places = fitting;
            layOut();
        }
        MadeLevelScene.drawTitle(canvas, words.of("made.replay"), places);
        tiles.draw(canvas);
        MakingNote.draw(
                canvas,
                words,
                making,
                WIDTH / 2.0,
                HEIGHT / 2.0,
                steps,
                director.settings().motion());
    }

    @Override
    public boolean isForHands() {
        return true;
    }

    @Override
    public void closed() {
        making.stop();
    }

    @Override
    public Tiles tiles() {
        return tiles;
    }
}
