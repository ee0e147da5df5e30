using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Commands.Settings;

namespace Engraver.App.Options;

/// <summary>The sheet of OPTIONS: every setting on pages, with a search over all of them. Changes are made by the commands that can also be
/// typed.</summary>
public sealed class OptionsModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private IReadOnlyList<OptionRow> _rows = [];
    private bool _isOpen;
    private string _search = "";
    private string? _page;

    public OptionsModel(DesktopModel desk)
    {
        _desk = desk;
        Cancel = new RelayCommand(() => IsOpen = false);
        Apply = new RelayCommand(() => _ = ApplyAsync());
        Accept = new RelayCommand(() => _ = AcceptAsync());
    }

    public bool IsOpen
    {
        get => _isOpen;
        private set => SetProperty(ref _isOpen, value);
    }

    /// <summary>Titles of the pages.</summary>
    public IReadOnlyList<string> Pages { get; private set; } = [];

    /// <summary>The page in front; a search shows rows of all pages.</summary>
    public string? Page
    {
        get => _page;
        set
        {
            if (value is null || !SetProperty(ref _page, value)) return;
            if (_search.Length > 0) SetProperty(ref _search, "", nameof(Search));
            OnPropertyChanged(nameof(Shown));
        }
    }

    public string Search
    {
        get => _search;
        set
        {
            if (!SetProperty(ref _search, value ?? "")) return;
            OnPropertyChanged(nameof(Shown));
            OnPropertyChanged(nameof(HasNoMatch));
        }
    }

    /// <summary>The rows of the page, or the matches of the search.</summary>
    public IReadOnlyList<OptionRow> Shown => _search.Trim().Length > 0 ? [.. _rows.Where(row => row.Entry.Matches(_search))] : [.. _rows.Where(row => row.Entry.PageTitle == _page)];

    public bool HasNoMatch => IsOpen && Shown.Count == 0;

    /// <summary>Discards all changes.</summary>
    public RelayCommand Cancel { get; }

    /// <summary>Applies the changes; the sheet stays open.</summary>
    public RelayCommand Apply { get; }

    /// <summary>OK: applies the changes and closes the sheet, unless a value is invalid.</summary>
    public RelayCommand Accept { get; }

    public void Open()
    {
        Read();
        _search = "";
        OnPropertyChanged(null);
        IsOpen = true;
    }

    /// <summary>Runs the command of each changed setting, in order.</summary>
    /// <returns>False if one was refused; the reason is shown beside it.</returns>
    public async Task<bool> ApplyAsync()
    {
        foreach (var row in _rows) row.Error = row.Entry.RefusalOf(row.Typed) ?? "";
        if (_rows.FirstOrDefault(row => row.HasError) is { } wrong) return ShowRefused(wrong);
        var shown = _rows.ToDictionary(row => row.Entry.Key, row => row.Typed, StringComparer.Ordinal);
        var done = new HashSet<string>(StringComparer.Ordinal);
        foreach (var row in _rows.Where(row => row.IsChanged).ToList())
        {
            var inputs = OptionTable.InputsFor(row.Entry, shown);
            if (!done.Add(string.Join('\n', inputs))) continue; // two settings of one command
            if (await ErrorOfAsync(inputs) is not { } refusal) continue;
            row.Error = refusal;
            return ShowRefused(row);
        }

        Read();
        OnPropertyChanged(nameof(Shown));
        return true;
    }

    private async Task AcceptAsync()
    {
        if (await ApplyAsync()) IsOpen = false;
    }

    /// <summary>Brings the row with the invalid value to the front.</summary>
    private bool ShowRefused(OptionRow row)
    {
        if (!Shown.Contains(row)) Page = row.Entry.PageTitle;
        return false;
    }

    private async Task<string?> ErrorOfAsync(IReadOnlyList<string> inputs)
    {
        switch (await _desk.Queue.RunAsync([.. inputs]))
        {
            case InputResult.Failed failed: return failed.Message;
            case InputResult.NotAccepted unclear: return unclear.Message;
            case InputResult.Cancelled: return Texts.Text.Get("Options.Cancelled");
            case InputResult.AwaitingInput:
                var asked = _desk.Prompt.Text;
                await _desk.Queue.CancelAsync();
                return asked;
            default: return null;
        }
    }

    private void Read()
    {
        _rows = [.. OptionTable.Of(_desk.Session).Select(entry => new OptionRow(entry))];
        Pages = [.. _rows.Select(row => row.Entry.PageTitle).Distinct()];
        _page ??= Pages[0];
    }
}
