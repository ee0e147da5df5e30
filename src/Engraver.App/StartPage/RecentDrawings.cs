using Engraver.App.Desk;

namespace Engraver.App.StartPage;

/// <summary>The recent drawings and the state of their files. Files are checked in the background, because a network folder can be slow.</summary>
public sealed class RecentDrawings
{
    private readonly DesktopModel _desk;
    private IReadOnlyList<string> _paths = [];
    private int _checking;

    public RecentDrawings(DesktopModel desk)
    {
        _desk = desk;
        desk.Notifications.Changed += UpdateList;
        UpdateList();
    }

    /// <summary>Raised when the list or the state of a file has changed.</summary>
    public event Action? Changed;

    /// <summary>The most recent first.</summary>
    public IReadOnlyList<RecentDrawing> All { get; private set; } = [];

    /// <summary>Files are being checked.</summary>
    internal bool IsChecking => _checking > 0;

    /// <summary>Checks again which files exist.</summary>
    public void Refresh() => _ = CheckFilesAsync(_paths);

    public void Remove(RecentDrawing gone)
    {
        ArgumentNullException.ThrowIfNull(gone);
        _desk.Session.Settings.Change(settings => settings.WithoutRecent(gone.Path));
        UpdateList();
    }

    private void UpdateList()
    {
        var paths = _desk.Session.Settings.Current.RecentFiles;
        if (ReferenceEquals(paths, _paths)) return;
        _paths = paths;
        var known = All.ToDictionary(drawing => drawing.Path);
        Apply([.. paths.Distinct().Select(path => known.GetValueOrDefault(path) ?? new RecentDrawing(path, null, false))]);
        Refresh();
    }

    private async Task CheckFilesAsync(IReadOnlyList<string> paths)
    {
        _checking++;
        try
        {
            var found = await Task.Run(() => paths.Distinct().Select(RecentDrawing.Of).ToList());
            if (ReferenceEquals(paths, _paths)) Apply(found);
        }
        finally
        {
            _checking--;
        }
    }

    private void Apply(IReadOnlyList<RecentDrawing> drawings)
    {
        if (drawings.SequenceEqual(All)) return;
        All = drawings;
        Changed?.Invoke();
    }
}
