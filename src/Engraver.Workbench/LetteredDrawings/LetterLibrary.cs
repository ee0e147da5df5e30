using System.Collections.Concurrent;
using Engraver.Core.Drawings;
using Engraver.Fonts.Finding;
using Engraver.Fonts.OpenType;
using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.LetteredDrawings;

/// <summary>The fonts that a drawing can use: those beside it, those in the folder of the program, those of the system.</summary>
public static class LetterLibrary
{
    /// <summary>Name of the program's folder for fonts.</summary>
    public const string Folder = "fonts";

    private static readonly ConcurrentDictionary<string, Known> s_libraries = new(StringComparer.Ordinal);

    /// <summary>The program's folder for fonts of the user.</summary>
    public static string ProgramFolder => Path.Combine(AppContext.BaseDirectory, Folder);

    /// <summary>The fonts for one preparation. Font files are read once for each folder of drawings, and again when one of them or the substitution table was
    /// changed, added or removed there.</summary>
    public static LetterFonts FontsOf(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var beside = drawing.IsNew ? "" : Path.GetDirectoryName(Path.GetFullPath(drawing.FileName)) ?? "";
        var changed = (ChangeOf(beside), ChangeOf(ProgramFolder));
        var known = s_libraries.AddOrUpdate(beside, folder => Known.Of(folder, changed), (folder, earlier) => earlier.Changed == changed ? earlier : Known.Of(folder, changed));
        return new LetterFonts(drawing.Styles, known.Library, known.Substitutes.Faults);
    }

    /// <summary>The last change of a folder, of a font file in it, or of its substitution table.</summary>
    private static DateTime ChangeOf(string folder)
    {
        if (folder.Length == 0 || !Directory.Exists(folder)) return default;
        try
        {
            return Directory.EnumerateFiles(folder).Where(IsOfFonts).Select(File.GetLastWriteTimeUtc).Append(Directory.GetLastWriteTimeUtc(folder)).Max();
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return Directory.GetLastWriteTimeUtc(folder);
        }
    }

    private static bool IsOfFonts(string path) => FontLibrary.IsFontFile(path) || Path.GetFileName(path).Equals(FontSubstitutes.FileName, StringComparison.Ordinal);

    private sealed record Known((DateTime Beside, DateTime Program) Changed, FontLibrary Library, FontSubstitutes Substitutes)
    {
        public static Known Of(string beside, (DateTime Beside, DateTime Program) changed)
        {
            string[] folders = [.. beside.Length > 0 ? new[] { beside } : [], ProgramFolder, .. FontFolders.Standard];
            var substitutes = FontSubstitutes.In(folders);
            return new Known(changed, new FontLibrary(folders, substitutes), substitutes);
        }
    }
}
