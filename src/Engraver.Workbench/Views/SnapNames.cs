namespace Engraver.Workbench.Views;

/// <summary>The object snaps by name, with the numbers of AutoCAD's OSMODE.</summary>
public static class SnapNames
{
    private const int MinLength = 3;

    private static readonly IReadOnlyList<(string Word, int Bit)> s_all =
        [("ENDPOINT", 1), ("MIDPOINT", 2), ("CENTER", 4), ("NODE", 8), ("QUADRANT", 16), ("INTERSECTION", 32), ("PERPENDICULAR", 128), ("TANGENT", 256), ("NEAREST", 512)];

    /// <summary>The bit of a snap by a prefix of its name of at least three letters, case-insensitive. NONE is 0; null if there is no such snap.</summary>
    public static int? Find(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var word = typed.TrimStart('_');
        if (word.Length < MinLength) return null;
        if ("NONE".StartsWith(word, StringComparison.OrdinalIgnoreCase)) return 0;
        foreach (var (name, bit) in s_all)
        {
            if (name.StartsWith(word, StringComparison.OrdinalIgnoreCase)) return bit;
        }

        return null;
    }

    /// <summary>The abbreviations of the active snaps.</summary>
    public static string Text(int bits) => (bits & s_all.Sum(snap => snap.Bit)) == 0 ? "NONE" : string.Join(',', s_all.Where(snap => (bits & snap.Bit) != 0).Select(snap => snap.Word[..MinLength]));
}
