using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.FileDialogs;

/// <summary>The state of the file dialog: a folder with its rows, the name that is being typed, places to go to. Its result is the path of a file, which
/// answers the command that asks. Work on the file system runs in the background.</summary>
public sealed class FileDialogModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private FileRequest? _wanted;
    private FileRow? _chosen;
    private FileRow? _hovered;
    private FileFilter? _filter;
    private FileOrder _order;
    private string _name = "";
    private string _folder = "";
    private bool _isTyped;
    private string? _finding;
    private int _working;
    private Action? _stopReading;

    public FileDialogModel(DesktopModel desk)
    {
        _desk = desk;
        Preview = new PreviewModel(desk);
        Accept = new RelayCommand(() => _ = AcceptAsync());
        Show = new RelayCommand(() => Answered?.Invoke(null));
        Cancel = new RelayCommand(() => Cancelled?.Invoke());
        Up = new RelayCommand(GoUp);
        GoToPlace = new RelayCommand(place => GoTo((FilePlace)place!));
        SortBy = new RelayCommand(column => Sort((FileColumn)column!));
    }

    /// <summary>A file was chosen; null: the result is to be shown in the command window.</summary>
    internal event Action<FileChoice?>? Answered;

    /// <summary>The dialog was left.</summary>
    internal event Action? Cancelled;

    public PreviewModel Preview { get; }

    public RelayCommand Accept { get; }

    /// <summary>The result is shown in the command window and written nowhere.</summary>
    public RelayCommand Show { get; }

    public RelayCommand Cancel { get; }

    /// <summary>To the folder above.</summary>
    public RelayCommand Up { get; }

    /// <summary>To a place, the parameter.</summary>
    public RelayCommand GoToPlace { get; }

    /// <summary>By a column, the parameter.</summary>
    public RelayCommand SortBy { get; }

    public bool IsOpen => _wanted is not null;

    /// <summary>What the command that asks is called.</summary>
    public string Title { get; private set; } = "";

    public string AcceptText => Text.Get(_wanted is { Writes: true } ? "Files.Save" : "Files.Open");

    public bool CanShow => _wanted is { CanDisplayInstead: true };

    public IReadOnlyList<FilePlace> Places { get; private set; } = [];

    /// <summary>The folder that is shown, from the root on.</summary>
    public IReadOnlyList<FilePlace> Crumbs { get; private set; } = [];

    public IReadOnlyList<FileRow> Rows { get; private set; } = [];

    public IReadOnlyList<FileFilter> Filters { get; private set; } = [];

    public FileFilter? Filter
    {
        get => _filter;
        set
        {
            if (value is null || !SetProperty(ref _filter, value)) return;
            if (IsOpen && _wanted!.Writes && _name.Length > 0 && value.Extensions is [var ending, ..]) SetName(FileFilter.WithExtension(_name, ending, Filters), typed: _isTyped);
            if (IsOpen && _folder.Length > 0) Read(_folder);
        }
    }

    /// <summary>Full path of the folder that is shown.</summary>
    public string Folder
    {
        get => _folder;
        private set => SetProperty(ref _folder, value);
    }

    /// <summary>The row under the keys: chosen, or found by what was typed.</summary>
    public FileRow? Chosen
    {
        get => _chosen;
        set
        {
            if (!SetProperty(ref _chosen, value)) return;
            UpdatePreview();
            if (value is null) return;
            Finding = null;
            _isTyped = false;
            if (value.IsFile || !_wanted!.Writes) SetName(value.Name, typed: false);
        }
    }

    /// <summary>What is typed: a name or a path.</summary>
    public string Name
    {
        get => _name;
        set
        {
            if (!SetProperty(ref _name, value ?? "")) return;
            _isTyped = true;
            Finding = null;
            SelectFirstMatch();
        }
    }

    /// <summary>The name was typed letter by letter, and not put there by a choice.</summary>
    internal bool IsTyped => _isTyped;

    /// <summary>What is wrong, or has to be known; null for nothing.</summary>
    public string? Finding
    {
        get => _finding;
        private set => SetProperty(ref _finding, value);
    }

    public bool IsEmpty => Rows.Count == 0 && _stopReading is null && _finding is null;

    public string NameHeader => HeaderOf(FileColumn.Name);

    public string ChangedHeader => HeaderOf(FileColumn.Changed);

    public string BytesHeader => HeaderOf(FileColumn.Bytes);

    /// <summary>A folder is being read, or a name looked for.</summary>
    internal bool IsWorking => _working > 0;

    /// <summary>Shows the dialog.</summary>
    /// <param name="title">What the command that asks is called.</param>
    /// <param name="typed">What was typed already; empty for nothing.</param>
    internal void Open(FileRequest wanted, string title, string typed)
    {
        (_wanted, Title, _finding, _chosen, _hovered, _isTyped) = (wanted, title, null, null, null, typed.Length > 0);
        (Filters, _filter) = (FileFilter.For(wanted), null);
        OnPropertyChanged(nameof(Filter));
        OnPropertyChanged(nameof(Filters)); // a list that shows its new entries before one of them is chosen; it forgets the choice when it gets others
        var ending = wanted.Suggested is { } suggested ? Path.GetExtension(suggested) : null;
        _filter = Filters.FirstOrDefault(filter => ending is not null && filter.Extensions.Contains(ending)) ?? Filters[0];
        _name = typed.Length > 0 ? typed : wanted is { Writes: true, Suggested: { } offered } ? Path.GetFileName(offered) : "";
        (Rows, Places, Crumbs, _folder) = ([], [], [], ""); // a name alone has no place until the first folder is there
        OnPropertyChanged(null);
        _ = StartAsync(wanted);
        _ = FindPlacesAsync(wanted);
    }

    /// <summary>Hides the dialog and ends all its work.</summary>
    internal void Close()
    {
        if (_wanted is null) return;
        _wanted = null;
        StopReading();
        Preview.Show(null);
        (Rows, _chosen, _hovered) = ([], null, null);
        OnPropertyChanged(null);
    }

    /// <summary>Shows in the dialog why the file cannot be used.</summary>
    internal void ShowFinding(string sentence) => Finding = sentence;

    /// <summary>The row under the mouse is shown in the preview, as long as it is there.</summary>
    internal void Hover(FileRow? row)
    {
        _hovered = row;
        UpdatePreview();
    }

    /// <summary>Moves the choice in the list.</summary>
    internal void Move(int rows)
    {
        if (Rows.Count == 0) return;
        var now = _chosen is null ? -1 : Rows.ToList().IndexOf(_chosen);
        var next = now < 0 ? (rows > 0 ? 0 : Rows.Count - 1) : Math.Clamp(now + rows, 0, Rows.Count - 1);
        if (ReferenceEquals(_chosen, Rows[next]) || _chosen == Rows[next]) SetName(Rows[next].Name, typed: false);
        Chosen = Rows[next];
    }

    private string HeaderOf(FileColumn column) => Text.Get("FileColumn." + column) + (column != _order.Column ? "" : _order.IsDescending ? " ↓" : " ↑");

    private void UpdatePreview() => Preview.Show(_hovered ?? _chosen);

    private void SetName(string name, bool typed)
    {
        SetProperty(ref _name, name, nameof(Name));
        _isTyped = typed;
    }

    /// <summary>The first row that begins as what is typed.</summary>
    private void SelectFirstMatch()
    {
        var begun = TypedFileName.Parse(_name);
        _chosen = begun.Length == 0 ? null : Rows.FirstOrDefault(row => row.Name.StartsWith(begun, StringComparison.OrdinalIgnoreCase));
        OnPropertyChanged(nameof(Chosen));
        UpdatePreview();
    }

    /// <summary>A file or folder that was dropped on the dialog.</summary>
    internal void TakeDropped(string path)
    {
        SetName(TypedFileName.Format(path), typed: true);
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
            if (wanted.CanDisplayInstead) Answered?.Invoke(null);
            else Finding = Text.Get("Files.NameMissing");
            return;
        }

        var (typed, shown, working, ending, jumped) = (_name, _folder, _desk.Session.Folder, _filter is { Extensions: [var first, ..] } ? first : null, _chosen);
        var target = await WorkAsync(() => FileTarget.Find(typed, shown, working, wanted, ending, jumped));
        if (!ReferenceEquals(wanted, _wanted)) return;
        if (target is FileTarget.Folder into) Enter(into.Path);
        else if (target is FileTarget.NotFound nothing) Finding = nothing.Sentence;
        else if (target is FileTarget.TargetFile file) Answered?.Invoke(new FileChoice(wanted, file.Path, file.Exists));
    }

    /// <summary>Goes into a folder whose name was typed: it is not the name of a file.</summary>
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
        OnPropertyChanged(null);
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
            var (endings, stop) = (_filter?.Extensions ?? [], reading.Token);
            OnPropertyChanged(nameof(IsEmpty));
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

    /// <summary>A folder that cannot be read is reported, and the previous one remains.</summary>
    private void TakeListing(string folder, FolderListing listing, string? choose)
    {
        _stopReading = null;
        Finding = listing.Finding;
        if (listing is { Finding: not null, Rows.Count: 0 } && _folder.Length > 0 && Rows.Count > 0) return;
        Folder = folder;
        (Rows, Crumbs, _chosen) = (_order.Sort(listing.Rows), CrumbsOf(folder), null);
        OnPropertyChanged(null);
        if (_isTyped) SelectFirstMatch();
        else if (choose is not null && Rows.FirstOrDefault(row => row.Path == choose) is { } row) Chosen = row;
        else if (!_wanted!.Writes) SetName("", typed: false);
    }

    private async Task StartAsync(FileRequest wanted)
    {
        var folder = await WorkAsync(() => FileStart.FolderFor(wanted, _desk.Session));
        if (ReferenceEquals(wanted, _wanted) && _stopReading is null) Read(folder);
    }

    private async Task FindPlacesAsync(FileRequest wanted)
    {
        var (drawing, recent) = (_desk.Session.Document.FilePath, _desk.Session.Settings.Current.RecentFiles);
        var places = await WorkAsync(() => FilePlaces.Find(drawing, recent, file => !wanted.Writes && wanted.Matches(file)));
        if (!ReferenceEquals(wanted, _wanted)) return;
        Places = places;
        OnPropertyChanged(nameof(Places));
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

/// <summary>What was chosen in the dialog.</summary>
/// <param name="Path">Full path.</param>
/// <param name="Exists">The file is there already.</param>
internal sealed record FileChoice(FileRequest Wanted, string Path, bool Exists);
