using System.Globalization;
using Engraver.Core.Machines;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>The switching of the program in addition to the path (spindle, coolant, outputs) and its waits after a switch; compared with the job and the
/// profile if requested.</summary>
/// <param name="strokes">What operations require; null without them.</param>
/// <param name="hasOutputs">The dialect switches outputs by number.</param>
internal sealed class GcodeSwitches(MachineProfile profile, RequirementsJudge? terms, StrokeRequirements? strokes, bool hasOutputs)
{
    /// <summary>Times and speeds are written with four decimals.</summary>
    private const double Decimals = 0.0001;

    private const int Clockwise = 30;
    private const int CounterClockwise = 40;
    private const int SpindleOff = 50;
    private const int CoolantOn = 80;
    private const int CoolantOff = 90;
    private const int OutputOn = 640;
    private const int OutputOff = 650;

    private readonly bool _isSwitched = profile.Height is null;
    private int _loaded;
    private int _section;
    private bool _hasLoaded;
    private double? _selected;
    private int? _turning;
    private double? _speed;
    private bool _coolant;
    private int _outputs;
    private double _waited;
    private double _due;
    private int _line;

    public bool IsOutputOn { get; private set; }

    /// <summary>The program has a spindle, which is not the tool.</summary>
    public bool HasSpindle { get; } = profile.Spindle is not null || (profile.Height is not null && strokes is { StateSpindle: true });

    /// <summary>Number of the tool in the machine; 0 before the first change.</summary>
    private int Tool => _loaded != 0 ? _loaded : strokes?.Tools[0] ?? 0;

    /// <summary>The tool is on, as far as a switch controls it.</summary>
    public bool IsOn => (!HasSpindle && Turns) || _coolant || IsOutputOn;

    /// <summary>Switched on, at a speed (for a laser: a power) that is not set to 0.</summary>
    public bool Turns => _turning is not null && _speed != 0.0;

    /// <summary>The next section of the job begins with another tool.</summary>
    public bool IsChangeNext => strokes is { } required && _section + 1 < required.Stops.Count && !required.Stops[_section + 1];

    /// <summary>The next section of the job begins after a stop at which the tool remains.</summary>
    private bool IsStopNext => strokes is { } required && _section + 1 < required.Stops.Count && required.Stops[_section + 1];

    /// <summary>The codes of a line, in their order.</summary>
    public void Execute(GcodeBlock block, int line)
    {
        var before = _speed;
        (_speed, _selected) = (block['S'] ?? _speed, block['T'] ?? _selected);
        foreach (var code in block.Codes('M'))
        {
            var (wasOn, turned) = (IsOn, Turns);
            if (code is Clockwise or CounterClockwise or SpindleOff) _turning = code == SpindleOff ? null : code;
            else if (code is 70 or CoolantOn or CoolantOff) _coolant = code != CoolantOff;
            else if (code is >= 620 and <= OutputOff && block['P'] == profile.ToolOutput - 1) IsOutputOn = (code is 620 or OutputOn) != profile.ToolActiveLow;
            else if (code is >= 620 and <= OutputOff && BitOf(block['P']) is { } bit) _outputs = code is 620 or OutputOn ? _outputs | bit : _outputs & ~bit;
            else if (code is GcodeCodes.ToolChange || (code == GcodeCodes.Stop && strokes is { Tools.Count: > 1 })) Change(code, line);
            if (RequiredInstead(code, block['P']) is { } expected) terms?.AddDifference(line, Spelled(code, block['P']), expected);
            if (_isSwitched && IsOn != wasOn) Await(IsOn ? profile.ToolSettleSeconds : profile.OffSettleSeconds, line);
            else if (HasSpindle && Turns && (!turned || _speed != before)) Await(profile.Spindle?.SpinUpSeconds ?? 0.0, line);
        }
    }

    /// <summary>M6 loads the selected tool and stops the spindle; at a stop the operator changes it for the next one of the job, or lets it remain. The first
    /// M6 loads the tool of the first section.</summary>
    private void Change(int code, int line)
    {
        var (isStop, isAwaited) = (code == GcodeCodes.Stop, IsStopNext);
        if (isStop || _hasLoaded) _section++;
        _hasLoaded |= !isStop;
        var next = strokes is { } required && _section < required.Tools.Count ? required.Tools[_section] : 0;
        if (!isStop || !isAwaited) _loaded = isStop ? next : (int)(_selected ?? 0.0);
        if (!isStop) _turning = null;
        if (isStop && isAwaited) return;
        if (_loaded != next || next == 0 || (isAwaited && _section > 0)) terms?.AddDifference(line, isStop ? "M0" : $"T{NumberText.Whole(_loaded)} M6", next == 0 ? Wording.Get("GcodeReader.NoCode") : isAwaited ? "M0" : $"T{NumberText.Whole(next)} M6");
    }

    /// <summary>The program ends: it must have stopped before every repeat for which the job stops.</summary>
    public void End(int line)
    {
        if (IsStopNext) terms?.AddDifference(line, Wording.Get("GcodeReader.NoCode"), "M0");
    }

    /// <summary>G4.</summary>
    public void Wait(double seconds, int line)
    {
        if (_due == 0.0 && _waited == 0.0) _line = line;
        _waited += seconds;
    }

    /// <summary>Called when an axis moves or the program ends: before this, the program must have waited for the last switch, as long as an operation requires
    /// at this place, and for nothing else.</summary>
    /// <param name="more">What operations require, each possible; null for none.</param>
    public void EndWait(IReadOnlyList<double>? more = null)
    {
        if (more is { Count: > 0 } && !more.Any(wait => Math.Abs(_waited - _due - wait) <= Decimals)) _due += more[0];
        else if (more is { Count: > 0 }) _due = _waited;
        if (Math.Abs(_waited - _due) > Decimals) terms?.AddDifference(_line, $"G4 P{NumberText.Rounded(_waited, 4)}", $"G4 P{NumberText.Rounded(_due, 4)}");
        (_waited, _due) = (0.0, 0.0);
    }

    /// <summary>Called for a cut: checks that the spindle or laser runs at the requested speed.</summary>
    /// <param name="passing">The strokes that may be cut; null or empty: unknown.</param>
    public void Cut(int line, IReadOnlyList<StrokeRequirement>? passing)
    {
        if (terms is null) return;
        var usual = terms.Required.SpindleSpeed;
        if (passing is { Count: > 0 } && strokes is { Tools.Count: > 1 } && !passing.Any(stroke => stroke.Tool == Tool)) terms.AddDifference(line, $"T{NumberText.Whole(Tool)}", $"T{NumberText.Whole(passing[0].Tool)}");
        if (passing is { Count: > 0 } && hasOutputs && !passing.Any(stroke => stroke.Outputs == _outputs)) terms.AddDifference(line, SpelledOutputs(_outputs), SpelledOutputs(passing[0].Outputs));
        if (!(HasSpindle || (_isSwitched && (IsRequired("m3") || IsRequired("m4"))))) return;
        List<double> allowed = passing is { Count: > 0 } ? [.. passing.Select(stroke => stroke.Power is { } percent ? percent / 100.0 * usual : stroke.Spindle ?? usual)] : strokes is null ? [usual] : [];
        if (allowed.Count > 0 && !allowed.Exists(speed => Math.Abs((_speed ?? double.NaN) - speed) <= Decimals)) terms.AddDifference(line, _speed is { } actual ? $"S{NumberText.Rounded(actual, 4)}" : Wording.Get("GcodeReader.NoSpeed"), $"S{NumberText.Rounded(allowed[0], 4)}");
    }

    private void Await(double seconds, int line)
    {
        EndWait();
        (_due, _line) = (seconds, line);
    }

    private bool IsRequired(string code) => terms?.Required.ToolSwitch == code;

    /// <summary>The code that the job requires instead of a code; null for a required code, and for a code that only ends a state.</summary>
    private string? RequiredInstead(int code, double? output)
    {
        if (terms is null) return null;
        var isAsked = code switch
        {
            20 or 300 or 480 or SpindleOff or CoolantOff => true,
            GcodeCodes.ToolChange or GcodeCodes.Stop => strokes is { Tools.Count: > 1 }, // the tool itself is compared where it is changed
            Clockwise => HasSpindle || (_isSwitched && IsRequired("m3")),
            CounterClockwise => _isSwitched && IsRequired("m4"),
            CoolantOn => _isSwitched && IsRequired("m8"),
            OutputOn or OutputOff when BitOf(output) is not null => true,
            OutputOn or OutputOff => _isSwitched && IsRequired("m64") && output == profile.ToolOutput - 1,
            _ => false,
        };
        if (isAsked) return null;
        if (HasSpindle && code is CounterClockwise) return "M3";
        if (!_isSwitched) return Wording.Get("GcodeReader.NoCode");
        return terms.Required.ToolSwitch switch { "m4" => "M4, M5", "m8" => "M8, M9", "m64" => string.Create(CultureInfo.InvariantCulture, $"M64 P{profile.ToolOutput - 1}, M65 P{profile.ToolOutput - 1}"), _ => "M3, M5" };
    }

    /// <summary>The bit of an output that operations switch, by its number in the program, which counts from 0; null for another one.</summary>
    private int? BitOf(double? output) => output is >= 0.0 and < 8.0 && (profile.OperationOutputs & (1 << (int)output)) is > 0 and var bit ? bit : null;

    private static string SpelledOutputs(int outputs) => outputs == 0 ? Wording.Get("GcodeReader.NoOutput") : string.Join(", ", OutputSwitch.Of(outputs).Select(output => string.Create(CultureInfo.InvariantCulture, $"M64 P{output.Output - 1}")));

    private static string Spelled(int code, double? output) => code is >= 620 and <= OutputOff ? $"M{NumberText.Rounded(code / 10.0, 4)} P{NumberText.Rounded(output ?? 0.0, 4)}" : $"M{NumberText.Rounded(code / 10.0, 4)}";
}
