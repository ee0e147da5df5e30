using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Texts;
using Engraver.Workbench.Machines.Alarms;

namespace Engraver.App.Alarms;

/// <summary>An alarm: time, sentence, place, and what to do.</summary>
public sealed class AlarmRow(Alarm alarm, TimeZoneInfo zone, RelayCommand acknowledge)
{
    public int Number => alarm.Number;

    public string Time => TimeZoneInfo.ConvertTime(alarm.Time, zone).ToString("HH:mm:ss", CultureInfo.InvariantCulture);

    public string State => Text.Get("AlarmState." + alarm.State);

    public string What => alarm.Count > 1 ? Text.Get("Alarms.Again", alarm.What, alarm.Count) : alarm.What;

    public string Where => alarm.Where;

    public string ToDo => alarm.ToDo;

    /// <summary>Shows the priority by shape as well as by colour: the first-out alarm has its own mark.</summary>
    public string Mark => alarm.IsFirstOut ? "▲ 1" : "▲";

    public bool IsActive => alarm.IsActive;

    public bool NeedsAcknowledging => alarm.NeedsAcknowledging;

    public RelayCommand Acknowledge => acknowledge;
}
