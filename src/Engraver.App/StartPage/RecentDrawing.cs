using Engraver.App.Texts;
using Engraver.Core.Languages;

namespace Engraver.App.StartPage;

/// <summary>A recent drawing.</summary>
/// <param name="Path">Full path.</param>
/// <param name="Changed">Time of the last change of its file, local time; null if unknown.</param>
/// <param name="IsMissing">The file no longer exists.</param>
public sealed record RecentDrawing(string Path, DateTime? Changed, bool IsMissing)
{
    public string Name => TextCatalogue.Fact(System.IO.Path.GetFileName(Path));

    public string Folder => TextCatalogue.Fact(System.IO.Path.GetDirectoryName(Path) ?? "");

    public string Tip => TextCatalogue.Fact(Path);

    public bool Exists => !IsMissing;

    /// <summary>The time of the last change, or that the file is missing.</summary>
    public string Date => IsMissing ? Text.Get("StartPage.NotFound") : Changed is { } date ? Text.Get("Files.Date", date) : "";

    /// <summary>Reads the present state of the file; for a thread of the pool.</summary>
    public static RecentDrawing Of(string path)
    {
        var file = new FileInfo(path);
        return file.Exists ? new RecentDrawing(path, file.LastWriteTime, false) : new RecentDrawing(path, null, true);
    }
}
