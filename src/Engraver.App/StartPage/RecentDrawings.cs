using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Languages;

namespace Engraver.App.StartPage;

/// <summary>The recent drawings and the state of their files. Files are checked in the background, because a network folder can be slow.</summary>
public sealed class RecentDrawings
{
    private readonly DesktopModel _desk;
    private IReadOnlyList<string> _paths = [];
    private int _asking;

    public RecentDrawings(DesktopModel desk)
    {
        _desk = desk;
        desk.Notifications.Changed += Look;
        Look();
    }

    /// <summary>Raised when the list or the state of a file has changed.</summary>
    public event Action? Changed;

    /// <summary>The most recent first.</summary>
    public IReadOnlyList<RecentDrawing> All { get; private set; } = [];

    /// <summary>Files are being checked.</summary>
    internal bool IsAsking => _asking > 0;

    /// <summary>Checks again which files exist.</summary>
    public void Refresh() => _ = AskAsync(_paths);

    public void Remove(RecentDrawing gone)
    {
        ArgumentNullException.ThrowIfNull(gone);
        _desk.Session.Settings.Change(settings => settings.WithoutRecent(gone.Path));
        Look();
    }

    private void Look()
    {
        var paths = _desk.Session.Settings.Current.RecentFiles;
        if (ReferenceEquals(paths, _paths)) return;
        _paths = paths;
        var known = All.ToDictionary(drawing => drawing.Path);
        Take([.. paths.Distinct().Select(path => known.GetValueOrDefault(path) ?? new RecentDrawing(path, null, false))]);
        Refresh();
    }

    private async Task AskAsync(IReadOnlyList<string> paths)
    {
        _asking++;
        try
        {
            var found = await Task.Run(() => paths.Distinct().Select(RecentDrawing.Of).ToList());
            if (ReferenceEquals(paths, _paths)) Take(found);
        }
        finally
        {
            _asking--;
        }
    }

    private void Take(IReadOnlyList<RecentDrawing> drawings)
    {
        if (drawings.SequenceEqual(All)) return;
        All = drawings;
        Changed?.Invoke();
    }
}

/// <summary>A recent drawing.</summary>
/// <param name="Path">Full path.</param>
/// <param name="Changed">Time of the last change of its file, local time; null if unknown.</param>
/// <param name="IsGone">The file no longer exists.</param>
public sealed record RecentDrawing(string Path, DateTime? Changed, bool IsGone)
{
    public string Name => TextCatalogue.Fact(System.IO.Path.GetFileName(Path));

    public string Folder => TextCatalogue.Fact(System.IO.Path.GetDirectoryName(Path) ?? "");

    public string Tip => TextCatalogue.Fact(Path);

    public bool IsThere => !IsGone;

    /// <summary>The time of the last change, or that the file is missing.</summary>
    public string Date => IsGone ? Text.Get("StartPage.NotFound") : Changed is { } date ? Text.Get("Files.Date", date) : "";

    /// <summary>Reads the present state of the file; for a thread of the pool.</summary>
    public static RecentDrawing Of(string path)
    {
        var file = new FileInfo(path);
        return file.Exists ? new RecentDrawing(path, file.LastWriteTime, false) : new RecentDrawing(path, null, true);
    }
}
