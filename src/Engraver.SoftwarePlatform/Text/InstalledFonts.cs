using Avalonia.Media;
using Engraver.Fonts;
using Engraver.Fonts.OpenType;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>The usable faces in the font folders, searched when first needed. Broken files are left out.</summary>
internal sealed class InstalledFonts(IReadOnlyList<string> folders)
{
    private readonly Lazy<IReadOnlyList<SoftwareTypeface>> _faces = new(() => [.. FontFolders.Files(folders).SelectMany(Open)]);

    public IReadOnlyList<SoftwareTypeface> Faces => _faces.Value;

    public IEnumerable<string> FamilyNames => Faces.Select(face => face.FamilyName).Distinct(StringComparer.OrdinalIgnoreCase);

    public IEnumerable<SoftwareTypeface> Family(string name) => Faces.Where(face => string.Equals(face.FamilyName, name, StringComparison.OrdinalIgnoreCase));

    private static IEnumerable<SoftwareTypeface> Open(string path)
    {
        var faces = new List<SoftwareTypeface>();
        try
        {
            var source = new DiskFontSource(path);
            var count = FontFile.CountFaces(source);
            for (var i = 0; i < count; i++)
            {
                if (SoftwareTypeface.TryCreate(source, i, FontSimulations.None) is { } face)
                    faces.Add(face);
            }
        }
        catch (BrokenFontException)
        {
            return faces;
        }
        return faces;
    }
}
