package rigibo.fuzz;

import rigibo.fuzz.file.FileFailure;
import rigibo.fuzz.file.FileJudge;
import rigibo.fuzz.judge.Tally;
import rigibo.fuzz.judge.Watch;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Tries files in the game. */
final class FilesSubject implements Subject {

    private final Tally tally;
    private final Watch watch;
    private final Path wrong;
    private FileJudge judge;

    /**
     * A subject.
     *
     * @param wrong where files that go wrong are kept
     */
    FilesSubject(Tally tally, Watch watch, Path wrong) {
        this.tally = tally;
        this.watch = watch;
        this.wrong = wrong;
    }

    @Override
    public String title() {
        return "files";
    }

    @Override
    public String again(long seed, long index) {
        return Subject.super.again(seed, index) + " --files 1";
    }

    @Override
    public Optional<String> tried(long seed, long index) {
        watch.begins("making whole files");
        judge = judge == null ? new FileJudge() : judge;
        watch.begins("file " + index);
        Optional<FileFailure> failure = judge.judge(seed, index);
        tally.count(Tally.Of.FILES);
        if (judge.isRefused()) {
            tally.count(Tally.Of.FILES_REFUSED);
        }
        return failure.map(found -> words(found, seed, index));
    }

    private String words(FileFailure failure, long seed, long index) {
        Path kept = wrong.resolve(seed + "-" + index + "-" + failure.file().name());
        try {
            Files.createDirectories(wrong);
            Files.write(kept, failure.file().bytes());
        } catch (IOException disk) {
            throw new UncheckedIOException(disk);
        }
        return "a mutated " + failure.kind() + ", " + kept + ": " + failure.words();
    }
}
