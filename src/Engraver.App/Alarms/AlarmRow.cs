using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Texts;
using Engraver.Workbench.Machines.Alarms;

namespace Engraver.App.Alarms;

/// <summary>An alarm: when, what, where, what to do.</summary>
public sealed class AlarmRow(Alarm alarm, TimeZoneInfo zone, Act acknowledge)
{
    public int Number => alarm.Number;

    public string Time => TimeZoneInfo.ConvertTime(alarm.Time, zone).ToString("HH:mm:ss", CultureInfo.InvariantCulture);

    public string State => Text.Get("AlarmState." + alarm.State);

    public string What => alarm.Count > 1 ? Text.Get("Alarms.Again", alarm.What, alarm.Count) : alarm.What;

    public string Where => alarm.Where;

    public string ToDo => alarm.ToDo;

    /// <summary>Priority by shape as well as colour: the first-out has a mark of its own.</summary>
    public string Mark => alarm.IsFirstOut ? "▲ 1" : "▲";

    public bool IsActive => alarm.IsActive;

    public bool NeedsAcknowledging => alarm.NeedsAcknowledging;

    public Act Acknowledge => acknowledge;
}
