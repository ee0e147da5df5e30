using Engraver.Fonts.OpenType;

namespace Engraver.Fonts.Finding;

/// <summary>Which font replaces another: a list of lines <c>wanted;substitute</c>, as AutoCAD's acad.fmp. Both are names of files, of families, or
/// "engraver" and "engraver-double" for the fonts of the program. Several lines for the same font are tried in their order.</summary>
public sealed class FontSubstitutes
{
    /// <summary>Of a user's own table, beside the drawing or in the program's folder of fonts.</summary>
    public const string FileName = "fonts.fmp";

    private static readonly Lazy<IReadOnlyDictionary<string, IReadOnlyList<string>>> s_standard = new(ReadStandard);

    private readonly IReadOnlyDictionary<string, IReadOnlyList<string>> _own;

    private FontSubstitutes(IReadOnlyDictionary<string, IReadOnlyList<string>> own, IReadOnlyList<SubstituteFault> faults)
    {
        _own = own;
        Faults = faults;
    }

    /// <summary>The table of the program alone.</summary>
    public static FontSubstitutes Standard { get; } = new(new Dictionary<string, IReadOnlyList<string>>(), []);

    /// <summary>The lines of the user's tables that cannot be read.</summary>
    public IReadOnlyList<SubstituteFault> Faults { get; }

    /// <summary>The user's tables of these folders, the first one first, before the table of the program. Folders of the system have none.</summary>
    public static FontSubstitutes In(IEnumerable<string> folders)
    {
        var system = FontFolders.Standard;
        var own = new SubstituteTable();
        foreach (var folder in folders.Where(folder => !system.Contains(folder)).Distinct(StringComparer.Ordinal))
        {
            var path = Path.Combine(folder, FileName);
            if (!File.Exists(path)) continue;
            try
            {
                using var text = new StreamReader(path);
                own.Read(path, text);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                own.Refuse(path);
            }
        }

        return new FontSubstitutes(own.Lines, own.Faults);
    }

    /// <summary>The substitutes that the user's own table names for a font. They replace it even if it is installed.</summary>
    internal IReadOnlyList<string> OwnFor(FontRequest request) => For(_own, request);

    /// <summary>The substitutes of the program for a font that is not installed.</summary>
    internal static IReadOnlyList<string> StandardFor(FontRequest request) => For(s_standard.Value, request);

    /// <summary>Those of the file, then those of the family.</summary>
    private static IReadOnlyList<string> For(IReadOnlyDictionary<string, IReadOnlyList<string>> table, FontRequest request) =>
        table.Count == 0 ? [] : [.. ((string[])[request.File, request.Family]).Where(name => name.Length > 0).SelectMany(name => table.GetValueOrDefault(SubstituteTable.KeyOf(name)) ?? [])];

    private static IReadOnlyDictionary<string, IReadOnlyList<string>> ReadStandard()
    {
        const string Resource = "Engraver.Fonts.Finding.Data.substitutes.fmp";
        using var text = new StreamReader(typeof(FontSubstitutes).Assembly.GetManifestResourceStream(Resource)!);
        var table = new SubstituteTable();
        table.Read(Resource, text);
        return table.Lines;
    }
}
