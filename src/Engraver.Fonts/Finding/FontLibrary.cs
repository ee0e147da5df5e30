using System.Collections.Concurrent;
using Engraver.Fonts.OpenType;

namespace Engraver.Fonts.Finding;

/// <summary>Finds the fonts that a drawing names: those of the program, then files by name, then outline fonts by family, in the order of the folders; else
/// a substitute by the table, and the stroke font of the program as the last one. May be used by several threads.</summary>
/// <param name="folders">The folder of the drawing, the program's folder of fonts, those of the system (<see cref="FontFolders.Standard"/>). Only those of
/// the system are searched with the folders in them.</param>
public sealed class FontLibrary(IReadOnlyList<string> folders, FontSubstitutes substitutes)
{
    private readonly IReadOnlyList<FontFolder> _folders = [.. folders.Distinct(StringComparer.Ordinal).Select(folder => new FontFolder(folder, FontFolders.Standard.Contains(folder)))];
    private readonly FontFiles _files = new();
    private readonly ConcurrentDictionary<FontRequest, Lazy<FoundFont>> _found = new();

    /// <summary>True for the name of a file that may be a font.</summary>
    public static bool IsFontFile(string path) => FontFileName.HasKnownExtension(path);

    /// <summary>Never throws for a font that is missing or broken: returns a substitute and the reason. The second search for a font is cheap.</summary>
    public FoundFont Find(FontRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        return _found.GetOrAdd(request, key => new Lazy<FoundFont>(() => Search(key))).Value;
    }

    private FoundFont Search(FontRequest request)
    {
        if (request.File.Length > 0 && ProgramFonts.Named(request.File) is { } named) return Found(named, request, FontMatch.Exact, FontTrouble.None);
        if (FirstOf(substitutes.OwnFor(request), request) is { } own) return Found(own, request, FontMatch.ByTable, FontTrouble.None);

        var problem = FontTrouble.NotFound;
        OpenedFont? nearest = null;
        foreach (var candidate in Candidates(request))
        {
            if (_files.Open(candidate.Path, candidate.Face) is not { } font) problem = FontTrouble.Broken;
            else if (candidate.IsExact && problem != FontTrouble.Broken) return Found(font, request, FontMatch.Exact, FontTrouble.None);
            else nearest ??= font;
        }

        if (nearest is not null) return Found(nearest, request, FontMatch.Substitute, problem);
        return FirstOf(FontSubstitutes.StandardFor(request), request) is { } substitute
            ? Found(substitute, request, FontMatch.ByTable, problem)
            : Found(ProgramFonts.Engraver, request, FontMatch.Substitute, problem);
    }

    /// <summary>The first of these fonts that exists and can be read.</summary>
    private OpenedFont? FirstOf(IReadOnlyList<string> names, FontRequest style)
    {
        foreach (var name in names)
        {
            if (ProgramFonts.Named(name) is { } own) return own;
            var request = style with { File = name, Family = FontFileName.HasKnownExtension(name) ? "" : name };
            if (Candidates(request).Select(candidate => _files.Open(candidate.Path, candidate.Face)).FirstOrDefault(font => font is not null) is { } font) return font;
        }

        return null;
    }

    /// <summary>The files of the stated name in the order of the folders, then the faces of the family. Read one after the other, so that a font that is
    /// found by its file does not cost a search of all names.</summary>
    private IEnumerable<(string Path, int Face, bool IsExact)> Candidates(FontRequest request)
    {
        foreach (var name in FontFileName.Meant(request.File))
        {
            foreach (var folder in _folders)
            {
                if (folder.FileNamed(name) is { } path) yield return FaceIn(path, request);
            }
        }

        if (request.Family.Length == 0) yield break;
        foreach (var face in _folders.SelectMany(folder => folder.Family(request.Family, request))) yield return (face.Path, face.Index, face.Has(request));
    }

    /// <summary>The face of a file. In a collection it is that of the family and style; a file that is not bold or italic as the request states is not
    /// exact, because such a style means the family.</summary>
    private static (string Path, int Face, bool IsExact) FaceIn(string path, FontRequest request)
    {
        if (!FontFolders.IsOutlineFile(path) || FontFace.In(path) is not [var first, ..] faces) return (path, 0, true);
        var face = FontFolder.Nearest(faces, request.Family.Length > 0 ? request.Family : first.Names.Family, request).FirstOrDefault() ?? first;
        return (path, face.Index, !(request.IsBold && !face.Style.IsBold) && !(request.IsItalic && !face.Style.IsItalic));
    }

    private static FoundFont Found(OpenedFont font, FontRequest request, FontMatch match, FontTrouble trouble) => new(font.Font, request, match, trouble, font.Path, font.Sha256);
}
