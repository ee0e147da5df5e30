using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core;
using Engraver.Core.Machines;
using Engraver.Workbench.Machines;

namespace Engraver.App.MachineStrip;

/// <summary>The machine in one line: state as text, shape and colour, position, feed, tool, progress, and the keys.</summary>
public sealed class MachineStripModel : ObservableObject
{
    /// <summary>The change of the override by one press, as a factor of the programmed feed or rapid speed.</summary>
    private const double OverrideStep = 0.1;

    private const string Unknown = "–";
    private readonly DesktopModel _desk;
    private readonly ReportedSpeed _reportedSpeed = new();
    private MachineStatus _status = MachineStatus.Offline;

    public MachineStripModel(DesktopModel desk)
    {
        _desk = desk;
        Arm = new RelayCommand(() => _ = desk.Queue.RunAsync("CNCARM", "Stream"), () => KeyReasons.Arm(_status) is null);
        Start = new RelayCommand(() => _ = _status.State is MachineState.Held ? desk.Queue.RunAsync("CNCRESUME") : desk.StartArmedAsync(), () => KeyReasons.Start(_status) is null);
        Hold = new RelayCommand(desk.HoldNow, () => KeyReasons.Hold(_status) is null);
        Faster = new RelayCommand(() => desk.OverrideBy(OverrideStep), () => _status.FeedRatio < JobControl.FeedRange.Max);
        Slower = new RelayCommand(() => desk.OverrideBy(-OverrideStep), () => _status.FeedRatio > JobControl.FeedRange.Min);
        RapidsFaster = new RelayCommand(() => desk.OverrideRapidsBy(OverrideStep), () => _status.RapidRatio < JobControl.RapidRange.Max);
        RapidsSlower = new RelayCommand(() => desk.OverrideRapidsBy(-OverrideStep), () => _status.RapidRatio > JobControl.RapidRange.Min);
        Stop = new RelayCommand(desk.StopNow);
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public RelayCommand Arm { get; }

    /// <summary>Enabled only when the machine is armed, or when a job is held.</summary>
    public RelayCommand Start { get; }

    /// <summary>The action of START; with a held job it is to continue, as the key of that name on other machines.</summary>
    public string StartText => Text.Get(_status.State is MachineState.Held ? "Machine.Resume" : "Machine.Start");

    /// <summary>Why ARM is disabled, in one or two words under the key; empty while it is enabled.</summary>
    public string ArmReason => KeyReasons.ShortOf(KeyReasons.Arm(_status));

    /// <summary>The same for START.</summary>
    public string StartReason => KeyReasons.ShortOf(KeyReasons.Start(_status));

    /// <summary>The action of ARM; while it is disabled, the reason and what to do.</summary>
    public string ArmTip => KeyReasons.TipOf(KeyReasons.Arm(_status), "Machine.ArmTip", _status);

    public string StartTip => KeyReasons.TipOf(KeyReasons.Start(_status), "Machine.StartTip", _status);

    public string HoldTip => KeyReasons.TipOf(KeyReasons.Hold(_status), "Machine.HoldTip", _status);

    public string FasterTip => Text.Get(_status.FeedRatio < JobControl.FeedRange.Max ? "Machine.FasterTip" : "Machine.OverrideAtMaximum");

    public string SlowerTip => Text.Get(_status.FeedRatio > JobControl.FeedRange.Min ? "Machine.SlowerTip" : "Machine.OverrideAtMinimum");

    public string RapidsFasterTip => Text.Get(_status.RapidRatio < JobControl.RapidRange.Max ? "Machine.RapidsFasterTip" : "Machine.OverrideAtMaximum");

    public string RapidsSlowerTip => Text.Get(_status.RapidRatio > JobControl.RapidRange.Min ? "Machine.RapidsSlowerTip" : "Machine.OverrideAtMinimum");

    public RelayCommand Hold { get; }

    public RelayCommand Faster { get; }

    public RelayCommand Slower { get; }

    public RelayCommand RapidsFaster { get; }

    public RelayCommand RapidsSlower { get; }

    public RelayCommand Stop { get; }

    /// <summary>Feed in percent of the plan.</summary>
    public string Override => _status.FeedInForce < _status.FeedRatio
        ? Text.Get("Machine.OverrideLimited", _status.FeedInForce * 100.0, _status.FeedRatio * 100.0)
        : Text.Get("Machine.Override", _status.FeedRatio * 100.0);

    /// <summary>The feed differs from the plan: the figure is highlighted.</summary>
    public string OverrideKey => _status.FeedRatio == 1.0 ? "NeutralLampBrush" : "AbnormalLampBrush";

    /// <summary>Rapid speed in percent of the plan.</summary>
    public string Rapids => Text.Get("Machine.Rapids", _status.RapidRatio * 100.0);

    /// <summary>The same for the rapid speed.</summary>
    public string RapidsKey => _status.RapidRatio == 1.0 ? "NeutralLampBrush" : "AbnormalLampBrush";

    public string State => _status.State.DisplayText();

    /// <summary>Name of the geometry before the state.</summary>
    public string ShapeKey => "Shape." + _status.State;

    /// <summary>Name of the brush of the shape; grey unless the state is unusual.</summary>
    public string LampKey => _status.State switch
    {
        MachineState.Running => "NormalLampBrush",
        MachineState.Armed or MachineState.DryRun or MachineState.Moving => "ActLampBrush",
        MachineState.Holding or MachineState.Held or MachineState.Stopping or MachineState.Stopped or MachineState.Busy => "AbnormalLampBrush",
        MachineState.MotorsOff or MachineState.NotHomed or MachineState.NoOrigin => "AbnormalLampBrush",
        MachineState.Fault or MachineState.EmergencyStopOpen or MachineState.Deviated => "DangerLampBrush",
        _ => "NeutralLampBrush",
    };

    /// <summary>The reason of the state, or when it ends.</summary>
    public string Reason => _status.State == MachineState.Armed && _status.ArmedUntil is { } until
        ? Text.Get(_status.IsDryRun ? "Machine.ArmedDryFor" : "Machine.ArmedFor", Math.Max(0, Math.Ceiling((until - _desk.Time.GetUtcNow()).TotalSeconds)))
        : _status.Reason.Length > 0 ? _status.Reason : _status.Controller ?? Text.Get("Machine.NoController");

    public bool IsSimulation => _status.IsSimulation;

    public string X => Figure(_status.WorkPosition?.X ?? _status.MachinePosition?.X);

    public string Y => Figure(_status.WorkPosition?.Y ?? _status.MachinePosition?.Y);

    /// <summary>The machine has a Z axis.</summary>
    public bool HasZ => _desk.Session.Machine.Profile.Axes.Z is not null;

    /// <summary>Height above the zero of the drawing, or above the controller's zero while that one is unknown; the same as for X and Y.</summary>
    public string Z => Figure(_status.WorkHeight ?? _status.MachineHeight);

    public string MachineHeight => _status.MachineHeight is { } height ? Text.Get("Machine.Height", Figure(height)) : "";

    public string MachinePlace => _status.MachinePosition is { } place ? Text.Get("Machine.MachinePosition", Figure(place.X), Figure(place.Y)) : "";

    /// <summary>Speed along the path, mm/min: while a job runs, computed from the positions that the controller reports (<see cref="ReportedSpeed"/>),
    /// otherwise the speed that the controller reports.</summary>
    public string Feed => (_status.Speed ?? _reportedSpeed.Current) is { } speed ? (speed * 60.0).ToString("0", CultureInfo.InvariantCulture) : Unknown;

    public string Tool => _status.ToolCommanded switch { true => Text.Get("Machine.ToolOn"), false => Text.Get("Machine.ToolOff"), null => Unknown };

    /// <summary>Bit 0 is input 1; null: unknown.</summary>
    public int? Inputs => _status.Inputs;

    /// <summary>Bit 0 is output 1; null: unknown.</summary>
    public int? Outputs => _status.Outputs;

    /// <summary>Fraction of the planned time, 0 to 1: one long segment counts as much as the many short ones of the same duration.</summary>
    public double Progress => _status.Progress is { } at ? _desk.Derived.FractionDone(at) : 0.0;

    public string ProgressText => _status.Progress is { } at
        ? Text.Get("Machine.ProgressText", Progress * 100.0, ClockText.Format(at.Seconds))
        : Unknown;

    /// <summary>Number of cut segments and total; empty while there is no job with progress.</summary>
    public string SegmentsText => _status.Progress is { } at ? Text.Get("Machine.SegmentsText", at.SegmentsDone, at.SegmentCount) : "";

    /// <summary>Empty while there is no job with progress.</summary>
    public string TimeLeft => _status.Progress is { } at ? Text.Get("Machine.TimeLeft", ClockText.Format(_desk.Derived.SecondsLeft(at) * _desk.Derived.TimeFactor(_status.FeedInForce, _status.RapidRatio))) : "";

    private void Refresh()
    {
        _status = _desk.Session.Machine.Status;
        _reportedSpeed.Update(_status.State.IsJob() ? _status.Progress : null);
        OnPropertyChanged(null);
        Arm.RaiseCanExecuteChanged();
        Start.RaiseCanExecuteChanged();
        Hold.RaiseCanExecuteChanged();
        Faster.RaiseCanExecuteChanged();
        Slower.RaiseCanExecuteChanged();
        RapidsFaster.RaiseCanExecuteChanged();
        RapidsSlower.RaiseCanExecuteChanged();
    }

    private static string Figure(double? millimetres) => millimetres is { } value ? NumberText.Fixed(value, 3) : Unknown;
}
