using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Drawings;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.App.TextOffers;

/// <summary>Offers to engrave the texts of a drawing that would not be cut, once for each drawing. The offer waits while a command asks, the machine
/// moves, or a job is between two sections.</summary>
public sealed class TextOfferModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private readonly HashSet<string> _answered = new(StringComparer.Ordinal);
    private (Drawing? Drawing, DrawingSettings? Settings) _counted;
    private int _count;

    public TextOfferModel(DesktopModel desk)
    {
        _desk = desk;
        Accept = new RelayCommand(() => Answer(engraves: true));
        Decline = new RelayCommand(() => Answer(engraves: false));
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public bool IsOpen { get; private set; }

    public string Sentence => Text.Count("TextOffer.Question", _count);

    public RelayCommand Accept { get; }

    public RelayCommand Decline { get; }

    private void Refresh()
    {
        var state = _desk.Session.Document.Current;
        if (!ReferenceEquals(state.Drawing, _counted.Drawing) || !ReferenceEquals(state.Settings, _counted.Settings))
        {
            _counted = (state.Drawing, state.Settings);
            _count = state.Drawing is { } drawing ? UncutTexts.Count(drawing, state.Settings) : 0;
        }

        var isOpen = _count > 0 && !_answered.Contains(state.Drawing!.FileName) && _desk.Prompt.Command is null && !_desk.IsMoving && _desk.Session.Machine.Runs.Part is not { Break: not null };
        if (isOpen == IsOpen && !isOpen) return;
        IsOpen = isOpen;
        OnPropertyChanged(null);
    }

    private void Answer(bool engraves)
    {
        if (_counted.Drawing is not { } drawing) return;
        _answered.Add(drawing.FileName);
        if (engraves) _ = _desk.Queue.RunAsync("CNCTEXT", "Yes");
        Refresh();
    }
}
