using Engraver.Fonts.OpenType;

namespace Engraver.Fonts.Finding;

/// <summary>The font files of one folder. Names are listed when a font is first searched in it, tables of names are read when a family
/// is first searched.</summary>
internal sealed class FontFolder
{
    private readonly Lazy<IReadOnlyList<string>> _files;
    private readonly Lazy<IReadOnlyDictionary<string, string>> _byName;
    private readonly Lazy<IReadOnlyList<FontFace>> _faces;

    /// <param name="isDeep">True for folders with fonts in folders of their own, as those of the system; false for the folder of a drawing, which may be
    /// that of everything else too.</param>
    public FontFolder(string path, bool isDeep)
    {
        _files = new(() => [.. FontFolders.FilesIn(path, isDeep).Where(FontFileName.HasKnownExtension)]);
        _byName = new(() => _files.Value.GroupBy(file => Path.GetFileName(file), StringComparer.OrdinalIgnoreCase).ToDictionary(group => group.Key, group => group.First(), StringComparer.OrdinalIgnoreCase));
        _faces = new(() => [.. _files.Value.Where(FontFolders.IsOutlineFile).SelectMany(FontFace.In)]);
    }

    /// <returns>Null if there is no file of that name; case is ignored.</returns>
    public string? FileNamed(string name) => _byName.Value.GetValueOrDefault(name);

    /// <summary>The faces of a family, the one nearest to the requested style first.</summary>
    public IEnumerable<FontFace> Family(string family, FontRequest style) => Nearest(_faces.Value, family, style);

    /// <inheritdoc cref="Family"/>
    public static IEnumerable<FontFace> Nearest(IEnumerable<FontFace> faces, string family, FontRequest style) =>
        faces.Where(face => face.RankOf(family) is not null).OrderBy(face => face.Has(style) ? 0 : 1).ThenBy(face => face.RankOf(family)).ThenBy(face => face.Style.DistanceTo(style.IsBold, style.IsItalic));
}
