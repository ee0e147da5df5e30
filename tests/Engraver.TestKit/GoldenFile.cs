namespace Engraver.TestKit;

/// <summary>Compares a text with its expected file. With ENGRAVER_UPDATE_GOLDEN=1 the file is written instead (`./test --update-golden`).</summary>
public static class GoldenFile
{
    /// <summary>Expected files are to be written (ENGRAVER_UPDATE_GOLDEN=1).</summary>
    public static bool IsUpdating => Environment.GetEnvironmentVariable("ENGRAVER_UPDATE_GOLDEN") == "1";

    /// <summary>Throws with the first differing line when <paramref name="actual"/> is not the content of the file, or when the file is missing.</summary>
    /// <param name="path">Full path of the expected file.</param>
    /// <param name="actual">The output of the program; line ends are compared as LF.</param>
    public static void Check(string path, string actual)
    {
        var text = actual.ReplaceLineEndings("\n");
        if (IsUpdating)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            File.WriteAllText(path, text);
            return;
        }

        if (!File.Exists(path)) throw new GoldenFileException($"{path} is missing; run ./test --update-golden and read what it writes.");
        var expected = File.ReadAllText(path).ReplaceLineEndings("\n");
        if (expected != text) throw new GoldenFileException($"{path} differs: {FirstDifference(expected, text)}");
    }

    private static string FirstDifference(string expected, string actual)
    {
        var left = expected.Split('\n');
        var right = actual.Split('\n');
        var line = 0;
        while (line < left.Length && line < right.Length && left[line] == right[line]) line++;
        string At(string[] lines) => line < lines.Length ? lines[line] : "<end of text>";
        return $"line {line + 1}: expected '{At(left)}', got '{At(right)}'";
    }
}
