package rigibo.frontend.document;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

class PackTest {

    @TempDir Path folder;

    private final List<Problem> errors = new ArrayList<>();

    private Path zip(String... names) throws IOException {
        Path file = folder.resolve("pack.ZIP");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
            for (String name : names) {
                zip.putNextEntry(new ZipEntry(name));
                zip.write(name.getBytes(StandardCharsets.UTF_8));
            }
        }
        return file;
    }

    private List<String> texts(Path pack) {
        assertThat(Pack.is(pack)).isTrue();
        return Pack.read(pack, errors).stream().map(Pack.Entry::text).toList();
    }

    private String error() {
        assertThat(errors).hasSize(1);
        return errors.get(0).toString();
    }

    @Test
    void aZipFileGivesItsJsonFilesByName() throws IOException {
        Path zip = zip("z/b.json", "a.json", "__MACOSX/._a.json", "read.me", "z/a.json", "Ä.json");
        assertThat(texts(zip)).containsExactly("a.json", "z/a.json", "z/b.json", "Ä.json");
        assertThat(errors).isEmpty();
    }

    @Test
    void aFolderGivesItsOwnJsonFilesByName() throws IOException {
        Files.createDirectories(folder.resolve("within"));
        for (String name : List.of("b.json", "a.json", "within/c.json", ".d.json", "e.txt")) {
            Files.writeString(folder.resolve(name), name);
        }
        assertThat(texts(folder)).containsExactly("a.json", "b.json");
        assertThat(errors).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"../a.json", "a/../../b.json", "/etc/a.json", "x\\..\\a.json", "C:a.json"})
    void pathsThatLeadOutAreRefused(String name) throws IOException {
        assertThat(texts(zip(name))).isEmpty();
        assertThat(error()).contains("leads out of the pack");
    }

    @Test
    void aZipFileCutInHalfIsRefusedInWords() throws IOException {
        Path zip = zip("a.json");
        byte[] whole = Files.readAllBytes(zip);
        Files.write(zip, Arrays.copyOf(whole, whole.length / 2));
        assertThat(texts(zip)).isEmpty();
        assertThat(error()).startsWith(zip + ": is no zip file, or a damaged one");
    }

    @Test
    void tooManyFilesAreRefused() throws IOException {
        String[] names = new String[Pack.MOST_FILES + 1];
        for (int i = 0; i < names.length; i++) {
            names[i] = i + ".json";
            Files.writeString(folder.resolve(names[i]), "{}");
        }
        assertThat(texts(folder)).isEmpty();
        assertThat(error()).endsWith("holds 201 files, and a pack at most 200");
        errors.clear();
        Path zip = zip(names);
        assertThat(texts(zip)).isEmpty();
        assertThat(error()).endsWith("holds 201 files, and a pack at most 200");
    }

    /** Seventeen files of a megabyte each, which are packed into a thousandth. */
    @Test
    void whatUnpacksToTooMuchIsRefused() throws IOException {
        Path file = folder.resolve("large.zip");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
            for (int i = 0; i < 17; i++) {
                zip.putNextEntry(new ZipEntry(i + ".json"));
                zip.write(new byte[Bounds.BYTES]);
            }
        }
        texts(file);
        assertThat(error()).endsWith("unpacks to more than 16000000 bytes");
    }

    @Test
    void aFileLargerThanWeReadIsOneProblemAmongOthers() throws IOException {
        Path file = folder.resolve("large.zip");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
            zip.putNextEntry(new ZipEntry("a.json"));
            zip.write(new byte[50 * Bounds.BYTES]);
            zip.putNextEntry(new ZipEntry("b.json"));
            zip.write('b');
        }
        assertThat(texts(file)).containsExactly("b");
        assertThat(error()).contains("a.json", "is larger than 1000000 bytes");
    }

    @Test
    void emptyDamagedAndMissingPacksAreToldByName() throws IOException {
        texts(zip("read.me"));
        assertThat(error()).contains("pack.ZIP").endsWith("holds no file that ends with .json");
        errors.clear();
        texts(Files.writeString(folder.resolve("torn.zip"), "PK, and no more"));
        assertThat(error()).contains("torn.zip");
        errors.clear();
        texts(folder.resolve("none.zip"));
        assertThat(error()).contains("none.zip");
    }
}
