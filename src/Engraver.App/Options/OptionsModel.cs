using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Commands.Settings;

namespace Engraver.App.Options;

/// <summary>The sheet of OPTIONS: every setting on pages, with a search over all of them. Changes are made by the commands that can also be
/// typed.</summary>
public sealed class OptionsModel : Observable
{
    private readonly DesktopModel _desk;
    private IReadOnlyList<OptionRow> _rows = [];
    private bool _isOpen;
    private string _search = "";
    private string? _page;

    public OptionsModel(DesktopModel desk)
    {
        _desk = desk;
        Cancel = new Act(() => IsOpen = false);
        Apply = new Act(() => _ = ApplyAsync());
        Take = new Act(() => _ = TakeAsync());
    }

    public bool IsOpen
    {
        get => _isOpen;
        private set => Set(ref _isOpen, value);
    }

    /// <summary>Titles of the pages.</summary>
    public IReadOnlyList<string> Pages { get; private set; } = [];

    /// <summary>The page in front; a search shows rows of all pages.</summary>
    public string? Page
    {
        get => _page;
        set
        {
            if (value is null || !Set(ref _page, value)) return;
            if (_search.Length > 0) Set(ref _search, "", nameof(Search));
            Tell(nameof(Shown));
        }
    }

    public string Search
    {
        get => _search;
        set
        {
            if (!Set(ref _search, value ?? "")) return;
            Tell(nameof(Shown));
            Tell(nameof(FindsNothing));
        }
    }

    /// <summary>The rows of the page, or the matches of the search.</summary>
    public IReadOnlyList<OptionRow> Shown => _search.Trim().Length > 0 ? [.. _rows.Where(row => row.Entry.Holds(_search))] : [.. _rows.Where(row => row.Entry.PageTitle == _page)];

    public bool FindsNothing => IsOpen && Shown.Count == 0;

    /// <summary>Discards all changes.</summary>
    public Act Cancel { get; }

    /// <summary>Applies the changes; the sheet stays open.</summary>
    public Act Apply { get; }

    /// <summary>OK: applies the changes and closes the sheet, unless a value is invalid.</summary>
    public Act Take { get; }

    public void Open()
    {
        Read();
        _search = "";
        Tell(null);
        IsOpen = true;
    }

    /// <summary>Runs the command of each changed setting, in order.</summary>
    /// <returns>False if one was refused; the reason is shown beside it.</returns>
    public async Task<bool> ApplyAsync()
    {
        foreach (var row in _rows) row.Wrong = row.Entry.WhyNot(row.Typed) ?? "";
        if (_rows.FirstOrDefault(row => row.IsWrong) is { } wrong) return Refused(wrong);
        var shown = _rows.ToDictionary(row => row.Entry.Key, row => row.Typed, StringComparer.Ordinal);
        var done = new HashSet<string>(StringComparer.Ordinal);
        foreach (var row in _rows.Where(row => row.IsChanged).ToList())
        {
            var inputs = OptionTable.InputsFor(row.Entry, shown);
            if (!done.Add(string.Join('\n', inputs))) continue; // two settings of one command
            if (await WhyNotAsync(inputs) is not { } refusal) continue;
            row.Wrong = refusal;
            return Refused(row);
        }

        Read();
        Tell(nameof(Shown));
        return true;
    }

    private async Task TakeAsync()
    {
        if (await ApplyAsync()) IsOpen = false;
    }

    /// <summary>Brings the row with the invalid value to the front.</summary>
    private bool Refused(OptionRow row)
    {
        if (!Shown.Contains(row)) Page = row.Entry.PageTitle;
        return false;
    }

    private async Task<string?> WhyNotAsync(IReadOnlyList<string> inputs)
    {
        switch (await _desk.Queue.RunAsync([.. inputs]))
        {
            case InputResult.Failed failed: return failed.Sentence;
            case InputResult.NotUnderstood unclear: return unclear.Sentence;
            case InputResult.Cancelled: return Texts.Text.Get("Options.Cancelled");
            case InputResult.Asking:
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
