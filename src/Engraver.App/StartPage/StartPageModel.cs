using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.FileDialogs;
using Engraver.App.Texts;
using Engraver.Core.Languages;
using Engraver.Workbench.Commands;

namespace Engraver.App.StartPage;

/// <summary>The start page on the empty canvas: the recent drawings, and the samples. It is hidden when there is a drawing, or when a command requests a
/// point on the canvas.</summary>
public sealed class StartPageModel : ObservableObject
{
    private const int MaxSamples = 12;
    private readonly DesktopModel _desk;
    private readonly FileQuestions _files;
    private readonly RecentDrawings _recent;
    private bool _isShown;

    /// <param name="open">Runs OPEN as its menu entry does.</param>
    public StartPageModel(DesktopModel desk, FileQuestions files, RecentDrawings recent, System.Windows.Input.ICommand open)
    {
        (_desk, _files, _recent, Open) = (desk, files, recent, open);
        OpenRecent = new RelayCommand(drawing => OpenRecentDrawing((RecentDrawing)drawing!));
        OpenSample = new RelayCommand(sample => _ = files.OpenAsync(((FilePlace)sample!).Path));
        Remove = new RelayCommand(drawing => recent.Remove((RecentDrawing)drawing!));
        desk.Notifications.Changed += Refresh;
        recent.Changed += () => OnPropertyChanged(null);
        Refresh();
        _ = FindSamplesAsync();
    }

    public System.Windows.Input.ICommand Open { get; }

    /// <summary>Opens a drawing, the parameter; a missing one is reported.</summary>
    public RelayCommand OpenRecent { get; }

    /// <summary>Opens a sample, the parameter.</summary>
    public RelayCommand OpenSample { get; }

    /// <summary>Removes a drawing, the parameter, from the list.</summary>
    public RelayCommand Remove { get; }

    public IReadOnlyList<RecentDrawing> Recent => _recent.All;

    public bool HasRecent => _recent.All.Count > 0;

    public IReadOnlyList<FilePlace> Samples { get; private set; } = [];

    public bool HasSamples => Samples.Count > 0;

    public bool IsShown
    {
        get => _isShown;
        private set => SetProperty(ref _isShown, value);
    }

    internal void OpenRecentDrawing(RecentDrawing drawing)
    {
        if (drawing.IsMissing)
        {
            _desk.Notifications.Write(MessageKind.Warning, Text.Get("StartPage.NotFoundAdvice", drawing.Path));
            return;
        }

        _ = _files.OpenAsync(drawing.Path);
    }

    private void Refresh()
    {
        var shown = _desk.Session.Document.Current.Drawing is null && _desk.Prompt.PointRequest is null;
        if (shown && !_isShown) _recent.Refresh();
        IsShown = shown;
    }

    private async Task FindSamplesAsync()
    {
        Samples = await Task.Run(Find);
        OnPropertyChanged(nameof(Samples));
        OnPropertyChanged(nameof(HasSamples));
    }

    private static List<FilePlace> Find()
    {
        if (SampleFolder.Find() is not { } folder) return [];
        return [.. Directory.EnumerateFiles(folder, "*.dxf").Order(StringComparer.Ordinal).Take(MaxSamples).Select(path => new FilePlace(TextCatalogue.Fact(Path.GetFileNameWithoutExtension(path)), path, true))];
    }
}
