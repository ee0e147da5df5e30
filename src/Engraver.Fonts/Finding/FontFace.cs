using Engraver.Fonts.OpenType;

namespace Engraver.Fonts.Finding;

/// <summary>One face of an outline font file, by its tables of names and style alone.</summary>
internal sealed record FontFace(string Path, int Index, FontNames Names, FaceStyle Style)
{
    /// <summary>The faces of a file; none if it cannot be read. A face without names is left out.</summary>
    public static IReadOnlyList<FontFace> In(string path)
    {
        var faces = new List<FontFace>();
        try
        {
            var source = new DiskFontSource(path);
            var count = FontFile.CountFaces(source);
            for (var i = 0; i < count; i++)
            {
                var file = new FontFile(source, i);
                faces.Add(new FontFace(path, i, FontNames.Read(file.Table("name")), FaceStyle.Read(file)));
            }
        }
        catch (BrokenFontException)
        {
            return faces;
        }

        return faces;
    }

    public bool Has(FontRequest request) => Style.IsBold == request.IsBold && Style.IsItalic == request.IsItalic;

    /// <summary>0 for the family of at most four styles, 1 for that of all weights and widths, 2 for the full name; null for another family.</summary>
    public int? RankOf(string family) => Is(Names.StyleFamily, family) ? 0 : Is(Names.Family, family) ? 1 : Is(Names.Full, family) ? 2 : null;

    private static bool Is(string name, string other) => string.Equals(name, other, StringComparison.OrdinalIgnoreCase);
}
