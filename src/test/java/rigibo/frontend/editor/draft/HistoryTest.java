package rigibo.frontend.editor.draft;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class HistoryTest {

    private final History history = new History(NewLevel.draft());

    private void ballTo(double x) {
        Draft draft = history.present();
        history.change(draft.with("/ball/x", Decimal.of(x)));
    }

    private double ball() {
        return history.present().at("/ball/x").asDouble();
    }

    @Test
    void undoAndRedoWalkTheSameWay() {
        ballTo(3);
        ballTo(4);
        history.undo();
        assertThat(ball()).isEqualTo(3);
        history.undo();
        assertThat(history.present()).isEqualTo(NewLevel.draft());
        assertThat(history.canUndo()).isFalse();
        history.redo();
        history.redo();
        assertThat(ball()).isEqualTo(4);
        assertThat(history.canRedo()).isFalse();
    }

    @Test
    void aDragIsOneChange() {
        history.begin();
        ballTo(3);
        ballTo(4);
        ballTo(5);
        history.end();
        history.undo();
        assertThat(history.present()).isEqualTo(NewLevel.draft());
    }

    @Test
    void aDragThatEndsWhereItBeganIsNone() {
        history.begin();
        ballTo(3);
        ballTo(2);
        history.end();
        assertThat(history.canUndo()).isFalse();
    }

    @Test
    void aChangeEndsWhatCouldBeRedone() {
        ballTo(3);
        history.undo();
        ballTo(4);
        assertThat(history.canRedo()).isFalse();
    }
}
