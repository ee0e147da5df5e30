using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.Machines;

namespace Engraver.App.MachineStrip;

/// <summary>The machine in one line: state as text, shape and colour, position, feed, tool, progress, and the keys.</summary>
public sealed class MachineStripModel : Observable
{
    private const string Unknown = "–";
    private readonly DesktopModel _desk;
    private readonly ToldSpeed _told = new();
    private MachineStatus _status = MachineStatus.Offline;

    public MachineStripModel(DesktopModel desk)
    {
        _desk = desk;
        Arm = new Act(() => _ = desk.RunAsync("CNCARM", "Stream"), () => _status.State is MachineState.Ready);
        Start = new Act(() => _ = desk.StartArmedAsync(), () => _status.State is MachineState.Armed);
        Stop = new Act(desk.StopNow);
        desk.Changed += Look;
        Look();
    }

    public Act Arm { get; }

    /// <summary>Works only when armed.</summary>
    public Act Start { get; }

    public Act Stop { get; }

    public string State => Text.Get("State." + _status.State);

    /// <summary>Name of the geometry that stands before the state.</summary>
    public string ShapeKey => "Shape." + _status.State;

    /// <summary>Name of the brush of the shape; grey as long as nothing is unusual.</summary>
    public string LampKey => _status.State switch
    {
        MachineState.Running => "NormalLampBrush",
        MachineState.Armed => "ActLampBrush",
        MachineState.Stopping or MachineState.Busy or MachineState.MotorsOff => "AbnormalLampBrush",
        MachineState.Fault or MachineState.EmergencyStopOpen => "DangerLampBrush",
        _ => "NeutralLampBrush",
    };

    /// <summary>Why the state is what it is, or until when it lasts.</summary>
    public string Reason => _status.State == MachineState.Armed && _status.ArmedUntil is { } until
        ? Text.Get("Machine.ArmedFor", Math.Max(0, Math.Ceiling((until - _desk.Time.GetUtcNow()).TotalSeconds)))
        : _status.Reason.Length > 0 ? _status.Reason : _status.Controller ?? Text.Get("Machine.NoController");

    public bool IsSimulation => _status.IsSimulation;

    public string X => Figure(_status.WorkPosition?.X ?? _status.MachinePosition?.X);

    public string Y => Figure(_status.WorkPosition?.Y ?? _status.MachinePosition?.Y);

    public string MachinePlace => _status.MachinePosition is { } place ? Text.Get("Machine.Place", Figure(place.X), Figure(place.Y)) : "";

    /// <summary>While a job runs, what the places say that the controller tells of; else what it says itself.</summary>
    public string Feed => (_status.Speed ?? _told.Current) is { } speed ? (speed * 60.0).ToString("0", CultureInfo.InvariantCulture) : Unknown;

    public string Tool => _status.ToolCommanded switch { true => Text.Get("Machine.ToolOn"), false => Text.Get("Machine.ToolOff"), null => Unknown };

    /// <summary>Bit 0 is input 1; null is not known.</summary>
    public int? Inputs => _status.Inputs;

    /// <summary>Bit 0 is output 1; null is not known.</summary>
    public int? Outputs => _status.Outputs;

    public double Progress => _status.Progress?.Fraction ?? 0.0;

    public string ProgressText => _status.Progress is { } at
        ? Text.Get("Machine.ProgressText", at.Fraction * 100.0, ClockText.Format(at.Seconds))
        : Unknown;

    /// <summary>How many segments of how many are cut; empty while no job has a progress.</summary>
    public string SegmentsText => _status.Progress is { } at ? Text.Get("Machine.SegmentsText", at.SegmentsDone, at.SegmentCount) : "";

    /// <summary>Empty while no job has a progress.</summary>
    public string TimeLeft => _status.Progress is { } at ? Text.Get("Machine.TimeLeft", ClockText.Format(_desk.Derived.SecondsLeft(at.SegmentsDone, at.SegmentCount))) : "";

    private void Look()
    {
        _status = _desk.Session.Machine.Status;
        _told.Look(_status.State is MachineState.Running or MachineState.Stopping ? _status.Progress : null);
        Tell(null);
        Arm.Reconsider();
        Start.Reconsider();
    }

    private static string Figure(double? millimetres) => millimetres is { } value ? value.ToString("0.000", CultureInfo.InvariantCulture) : Unknown;
}
