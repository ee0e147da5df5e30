using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Workbench.Machines.Alarms;

namespace Engraver.App.Alarms;

/// <summary>The alarms, newest first. Acknowledging marks an alarm as seen and resets nothing.</summary>
public sealed class AlarmsModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private IReadOnlyList<Alarm> _shown = [];

    public AlarmsModel(DesktopModel desk)
    {
        _desk = desk;
        AcknowledgeAll = new RelayCommand(() => desk.Session.Machine.Alarms.AcknowledgeAll());
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public RelayCommand AcknowledgeAll { get; }

    public IReadOnlyList<AlarmRow> Rows { get; private set; } = [];

    public bool IsEmpty => Rows.Count == 0;

    private void Refresh()
    {
        var alarms = _desk.Session.Machine.Alarms.All;
        if (alarms.SequenceEqual(_shown)) return;
        _shown = alarms;
        Rows = [.. alarms.Reverse().Select(alarm => new AlarmRow(alarm, _desk.Time.LocalTimeZone, new RelayCommand(() => _desk.Session.Machine.Alarms.Acknowledge(alarm.Number))))];
        OnPropertyChanged(null);
    }
}
