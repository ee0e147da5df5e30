using Engraver.App.Texts;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.FileDialogs;

/// <content>Going from folder to folder, and taking the name. Everything that asks the file system runs in the background.</content>
public sealed partial class FileDialogModel
{
    /// <summary>A file or folder that was dropped on the dialog.</summary>
    internal void TakeDropped(string path)
    {
        SetName(TypedFileName.Write(path), typed: true);
        _ = AcceptAsync();
    }

    /// <summary>Enter: goes into the folder, or takes the file, that the name leads to.</summary>
    private async Task AcceptAsync()
    {
        if (_wanted is not { } wanted || (_folder.Length == 0 && !Path.IsPathRooted(_name.Trim()))) return;
        if (!_isTyped && _chosen is { IsFolder: true } folder)
        {
            Read(folder.Path);
            return;
        }

        if (_name.Trim().Length == 0)
        {
            if (wanted.MayShow) Answered?.Invoke(null);
            else Finding = Text.Get("Files.NameMissing");
            return;
        }

        var (typed, shown, working, ending, jumped) = (_name, _folder, _desk.Session.Folder, _filter is { Endings: [var first, ..] } ? first : null, _chosen);
        var target = await WorkAsync(() => FileTarget.Find(typed, shown, working, wanted, ending, jumped));
        if (!ReferenceEquals(wanted, _wanted)) return;
        if (target is FileTarget.Folder into) Enter(into.Path);
        else if (target is FileTarget.Nothing nothing) Finding = nothing.Sentence;
        else if (target is FileTarget.Chosen file) Answered?.Invoke(new FileChoice(wanted, file.Path, file.Exists));
    }

    /// <summary>Goes into a folder whose name was typed: it is no name of a file.</summary>
    private void Enter(string folder)
    {
        SetName("", typed: false);
        Read(folder);
    }

    private void GoUp()
    {
        if (Path.GetDirectoryName(_folder) is { } above) Read(above, _folder);
    }

    private void GoTo(FilePlace place)
    {
        if (place.IsFolder) Read(place.Path);
        else TakeDropped(place.Path);
    }

    private void Sort(FileColumn column)
    {
        _order = _order.Clicked(column);
        Rows = _order.Sort(Rows);
        Tell(null);
    }

    private void Read(string folder, string? choose = null)
    {
        StopReading();
        _ = ReadAsync(Path.GetFullPath(folder), choose);
    }

    private void StopReading()
    {
        _stopReading?.Invoke();
        _stopReading = null;
    }

    private async Task ReadAsync(string folder, string? choose)
    {
        using var reading = new CancellationTokenSource();
        Action stopReading = reading.Cancel;
        _stopReading = stopReading;
        try
        {
            var (endings, stop) = (_filter?.Endings ?? [], reading.Token);
            Tell(nameof(IsEmpty));
            var listing = await WorkAsync(() => FolderListing.Read(folder, endings, stop));
            if (_stopReading == stopReading) TakeListing(folder, listing, choose);
        }
        catch (OperationCanceledException)
        {
            // another folder is read, or the dialog was closed
        }
        finally
        {
            if (_stopReading == stopReading) _stopReading = null;
        }
    }

    /// <summary>A folder that cannot be read is told, and the one before stays.</summary>
    private void TakeListing(string folder, FolderListing listing, string? choose)
    {
        _stopReading = null;
        Finding = listing.Finding;
        if (listing is { Finding: not null, Rows.Count: 0 } && _folder.Length > 0 && Rows.Count > 0) return;
        Folder = folder;
        (Rows, Crumbs, _chosen) = (_order.Sort(listing.Rows), CrumbsOf(folder), null);
        Tell(null);
        if (_isTyped) Jump();
        else if (choose is not null && Rows.FirstOrDefault(row => row.Path == choose) is { } row) Chosen = row;
        else if (!_wanted!.Writes) SetName("", typed: false);
    }

    private async Task BeginAsync(FileWanted wanted)
    {
        var folder = await WorkAsync(() => FileStart.FolderFor(wanted, _desk.Session));
        if (ReferenceEquals(wanted, _wanted) && _stopReading is null) Read(folder);
    }

    private async Task FindPlacesAsync(FileWanted wanted)
    {
        var (drawing, recent) = (_desk.Session.Document.FilePath, _desk.Session.Settings.Current.RecentFiles);
        var places = await WorkAsync(() => FilePlaces.Find(drawing, recent, file => !wanted.Writes && wanted.Fits(file)));
        if (!ReferenceEquals(wanted, _wanted)) return;
        Places = places;
        Tell(nameof(Places));
    }

    private async Task<T> WorkAsync<T>(Func<T> work)
    {
        _working++;
        try
        {
            return await Task.Run(work);
        }
        finally
        {
            _working--;
        }
    }

    private static List<FilePlace> CrumbsOf(string folder)
    {
        var crumbs = new List<FilePlace>();
        for (var at = folder; at is not null; at = Path.GetDirectoryName(at)) crumbs.Add(new FilePlace(Path.GetFileName(at) is { Length: > 0 } name ? name : at, at, false));
        crumbs.Reverse();
        return crumbs;
    }
}
