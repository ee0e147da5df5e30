using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Machines;

namespace Engraver.App.HandMoves;

/// <summary>The Machine page: jog pad, positions to move to, homing, work origins, inputs and outputs. Moves by steps or to a position are commands; only
/// the continuous jog goes directly to the machine.</summary>
public sealed class HandMovesModel : ObservableObject, IDisposable
{
    private readonly DesktopModel _desk;
    private ContinuousJog? _jog;
    private Task _previousJog = Task.CompletedTask;
    private StepSize _step;
    private bool _isGuardOpen;

    public HandMovesModel(DesktopModel desk)
    {
        _desk = desk;
        Steps = [.. new double?[] { 0.01, 0.1, 1.0, 10.0, null }.Select(size => new StepSize(size, this))];
        _step = Steps[2];
        GoOrigin = Command("CNCGOTO", "Work", "0,0");
        GoStart = Command("CNCGOTO", "Start");
        GoPark = Command("CNCGOTO", "Park");
        GoClearance = Command("CNCGOTO", "Clearance");
        Home = Command("CNCHOME");
        ZeroAll = Command("CNCZERO", "All");
        ZeroX = Command("CNCZERO", "X");
        ZeroY = Command("CNCZERO", "Y");
        ZeroZ = Command("CNCZERO", "Z");
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    /// <summary>The clock that measures how long a key is held.</summary>
    public TimeProvider Time => _desk.Time;

    /// <summary>The step sizes; the last one is continuous jogging.</summary>
    public IReadOnlyList<StepSize> Steps { get; }

    public StepSize Step
    {
        get => _step;
        set
        {
            if (!SetProperty(ref _step, value)) return;
            foreach (var step in Steps) step.Refresh();
            PrepareJog();
        }
    }

    /// <summary>The rapid enable key, which allows the rapid speed, is held; Shift does the same.</summary>
    public bool IsFast { get; set; }

    public RelayCommand GoOrigin { get; }

    public RelayCommand GoStart { get; }

    public RelayCommand GoPark { get; }

    public RelayCommand GoClearance { get; }

    public RelayCommand Home { get; }

    public RelayCommand ZeroAll { get; }

    public RelayCommand ZeroX { get; }

    public RelayCommand ZeroY { get; }

    /// <summary>Only on a machine with a Z axis.</summary>
    public RelayCommand ZeroZ { get; }

    /// <summary>The axes that <see cref="ZeroAll"/> sets.</summary>
    public string ZeroAllText => Text.Get(HasZ ? "Pad.ZeroAllWithZ" : "Pad.ZeroAll");

    public IReadOnlyList<OriginRow> Origins { get; private set; } = [];

    public IReadOnlyList<IoRow> Inputs { get; private set; } = [];

    public IReadOnlyList<IoRow> Outputs { get; private set; } = [];

    /// <summary>While it is open, a click on an output asks to switch it.</summary>
    public bool IsGuardOpen
    {
        get => _isGuardOpen;
        set => SetProperty(ref _isGuardOpen, value);
    }

    /// <summary>The machine has a Z axis.</summary>
    public bool HasZ { get; private set; }

    /// <summary>Height of the tool above the zero of the drawing and of the controller; empty without a Z axis.</summary>
    public string Height { get; private set; } = "";

    public string Homed { get; private set; } = "";

    public bool IsNotHomed { get; private set; }

    /// <summary>A press on the pad would move the machine; otherwise the pad looks disabled, and a press shows the reason.</summary>
    public bool CanJog => RefusalReason() is null;

    /// <summary>A continuous jog is expected, because its step was chosen or the pad has the focus: prepares the controller, so that a press moves the
    /// machine immediately.</summary>
    public void PrepareJog()
    {
        if (Step.Millimetres is null && !_desk.IsMoving && RefusalReason() is null) _ = PrepareJogAsync();
    }

    private async Task PrepareJogAsync()
    {
        try
        {
            await _desk.Session.Machine.ReadyJogs.PrepareAsync(_desk.Session.NewRunJournal("jog"));
        }
        catch (Exception unready) when (unready is ControllerException or InvalidOperationException)
        {
            // A press shows the reason.
        }
    }

    /// <summary>A key of the pad was pressed.</summary>
    /// <param name="way">Direction of each axis, -1, 0 or 1.</param>
    /// <param name="shift">Shift is held.</param>
    public void Press(JogVelocity way, bool shift)
    {
        if (_jog is { IsReleased: false }) return;
        if (RefusalReason() is { } why)
        {
            _desk.Notifications.Write(MessageKind.Error, why);
            return;
        }

        if (Step.Millimetres is { } step)
        {
            if (!_desk.IsMoving || _desk.Session.Machine.Controls.IsHeld) StepBy(way, step);
            else _desk.Notifications.Write(MessageKind.Error, Text.Get("Pad.Busy")); // the jog before it has not ended yet
            return;
        }

        var jog = _desk.Session.Machine.Hand.Presence.BeginJog(way.At(Speed(shift)));
        var (before, journal) = (_previousJog, _desk.Session.NewRunJournal("jog"));
        var ended = Task.Run(() => JogAsync(jog, before, journal));
        (_jog, _previousJog) = (jog, ended);
        _ = ReportEndAsync(jog, ended);
    }

    /// <summary>The window responds and the key is held.</summary>
    public void KeepJogging(bool shift)
    {
        if (_jog is not { IsReleased: false } jog) return;
        jog.SetSpeed(Speed(shift));
        _desk.Session.Machine.Hand.Presence.Sign();
    }

    /// <summary>The key is released, the pad loses the focus or the window closes: the machine brakes. Never waits.</summary>
    public void Release() => _jog?.Release();

    /// <summary>Completes when the last jog has restored the controller.</summary>
    public Task Jogged => _previousJog;

    public void Dispose() => _jog?.Dispose();

    private string? RefusalReason()
    {
        var machine = _desk.Session.Machine;
        if (machine.Connection.Description is null) return Text.Get("Pad.NoController");
        if (machine.Status.MotorsOn == false) return Text.Get("Pad.MotorsOff");
        return _desk.IsMoving && !machine.Controls.IsHeld && _previousJog.IsCompleted ? Text.Get("Pad.Busy") : null;
    }

    /// <summary>The fastest speed (<see cref="HandSpeed"/>) requires the rapid enable key.</summary>
    private double Speed(bool shift)
    {
        var profile = _desk.Session.Machine.Profile;
        var fastest = HandSpeed.Max(profile, _desk.Session.Machine.Connection.IsHomed);
        return IsFast || shift ? fastest : Math.Min(profile.JogMmPerMinute, fastest);
    }

    private void StepBy(JogVelocity way, double step)
    {
        if (way.Z != 0.0) _ = _desk.Queue.RunAsync("CNCJOG", way.Z > 0.0 ? "Z+" : "Z-", NumberText.Rounded(step, 3));
        else _ = _desk.Queue.RunAsync("CNCJOG", $"{NumberText.Rounded(way.X * step, 3)},{NumberText.Rounded(way.Y * step, 3)}");
    }

    /// <param name="before">The previous jog, which restores the controller first.</param>
    private async Task<JobResult> JogAsync(ContinuousJog jog, Task before, string journal)
    {
        await before.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        return jog.IsReleased ? JobResult.NotStarted(0, "") : await _desk.Session.Machine.ReadyJogs.JogAsync(jog, journal).ConfigureAwait(false);
    }

    private async Task ReportEndAsync(ContinuousJog jog, Task<JobResult> ended)
    {
        try
        {
            var result = await ended;
            if (jog.Abandoned is { IsCompletedSuccessfully: true, Result: true }) _desk.Notifications.Write(MessageKind.Warning, Text.Get("Pad.WindowTooSlow"));
            if (result.Outcome != JobOutcome.Complete && result.Message.Length > 0) _desk.Notifications.Write(MessageKind.Error, result.Message);
            foreach (var left in result.NotRestored) _desk.Notifications.Write(MessageKind.Warning, left);
        }
        catch (Exception failure) when (failure is ControllerException or InvalidOperationException)
        {
            _desk.Notifications.Write(MessageKind.Error, failure.Message);
        }
        finally
        {
            jog.Dispose();
        }
    }

    private RelayCommand Command(params string[] inputs) => new(() => _ = _desk.Queue.RunAsync(inputs), () => _desk.Session.Machine.Connection.Description is not null && !_desk.IsMoving);

    private void Refresh()
    {
        var machine = _desk.Session.Machine;
        var (profile, status) = (machine.Profile, machine.Status);
        HasZ = profile.Axes.Z is not null;
        Height = HasZ ? Text.Get("Pad.Height", Millimetres(status.WorkHeight), Millimetres(status.MachineHeight)) : "";
        (Homed, IsNotHomed) = machine.Connection.IsHomed switch { true => (Text.Get("Pad.Homed"), false), false => (Text.Get("Pad.NotHomed"), true), null => ("", false) };
        var memory = machine.Connection.Lease?.Memory;
        IReadOnlyList<OriginRow> origins = [.. WorkOriginNames.All.Select(name => new OriginRow(name, Place(memory?.Origins.GetValueOrDefault(name), profile), memory?.Active == name))];
        if (!origins.SequenceEqual(Origins)) Origins = origins;
        IReadOnlyList<IoRow> inputs = [.. IoRows(profile.Inputs, status.Inputs)], outputs = [.. IoRows(profile.Outputs, status.Outputs)];
        if (!inputs.SequenceEqual(Inputs)) Inputs = inputs;
        if (!outputs.SequenceEqual(Outputs)) Outputs = outputs;
        OnPropertyChanged(null);
        foreach (var command in new[] { GoOrigin, GoStart, GoPark, GoClearance, Home, ZeroAll, ZeroX, ZeroY, ZeroZ }) command.RaiseCanExecuteChanged();
    }

    private static string Place(WorkOrigin? origin, MachineProfile profile) =>
        origin is null ? Text.Get("Pad.NotSet") : string.Join(", ", origin.ToMillimetres(profile).Select(axis => axis is { } set ? NumberText.Rounded(set, 3) : "–"));

    private static string Millimetres(double? height) => height is { } known ? NumberText.Fixed(known, 3) : "–";

    private static IEnumerable<IoRow> IoRows(IoLineNames names, int? bits) =>
        Enumerable.Range(1, 8).Select(line => new IoRow(line, names[line], bits is { } known ? (known >> (line - 1) & 1) != 0 : null));

    /// <summary>The operator chose an origin.</summary>
    public void ChooseOrigin(OriginRow origin) => _ = _desk.Queue.RunAsync("CNCORIGIN", origin.Name);

    /// <summary>The operator clicked an output.</summary>
    public void SwitchOutput(IoRow output)
    {
        if (IsGuardOpen) _ = _desk.Queue.RunAsync("CNCOUTPUT", output.Number.ToString(CultureInfo.InvariantCulture), output.IsOn == true ? "OFF" : "ON");
    }
}

/// <summary>A step size.</summary>
/// <param name="millimetres">Null: continuous.</param>
public sealed class StepSize(double? millimetres, HandMovesModel owner) : ObservableObject
{
    public double? Millimetres => millimetres;

    public string Name => millimetres is { } size ? size.ToString("0.##", CultureInfo.InvariantCulture) : Text.Get("Pad.Continuous");

    public bool IsChosen
    {
        get => owner.Step == this;
        set
        {
            if (value) owner.Step = this;
            OnPropertyChanged(nameof(IsChosen));
        }
    }

    public void Refresh() => OnPropertyChanged(nameof(IsChosen));
}

/// <summary>An input or an output.</summary>
/// <param name="IsOn">Null: unknown.</param>
public sealed record IoRow(int Number, string Name, bool? IsOn)
{
    public string State => IsOn switch { true => Text.Get("Pad.On"), false => Text.Get("Pad.Off"), null => Text.Get("Pad.Unknown") };

    public string Label => Name == Number.ToString(CultureInfo.InvariantCulture) ? Name : $"{Number} {Name}";
}
