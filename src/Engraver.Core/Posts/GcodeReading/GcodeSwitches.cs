using System.Globalization;
using Engraver.Core.Machines;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>The switching of the program in addition to the path (spindle, coolant, outputs) and its waits after a switch; compared with the job and the
/// profile if requested.</summary>
internal sealed class GcodeSwitches(MachineProfile profile, RequirementsJudge? terms)
{
    /// <summary>Times and speeds are written with four decimals.</summary>
    private const double Decimals = 0.0001;

    private const int Clockwise = 30;
    private const int SpindleOff = 50;
    private const int CoolantOn = 80;
    private const int CoolantOff = 90;
    private const int OutputOn = 640;
    private const int OutputOff = 650;

    private readonly bool _isSwitched = profile.Height is null;
    private int? _turning;
    private double? _speed;
    private bool _coolant;
    private double _waited;
    private double _due;
    private int _line;

    public bool IsOutputOn { get; private set; }

    /// <summary>The tool is on, as far as a switch controls it.</summary>
    public bool IsOn => (profile.Spindle is null && Turns) || _coolant || IsOutputOn;

    /// <summary>Switched on, at a speed (for a laser: a power) that is not set to 0.</summary>
    public bool Turns => _turning is not null && _speed != 0.0;

    /// <summary>The codes of a line, in their order.</summary>
    public void Execute(GcodeBlock block, int line)
    {
        _speed = block['S'] ?? _speed;
        foreach (var code in block.Codes('M'))
        {
            var (wasOn, turned) = (IsOn, Turns);
            if (code is Clockwise or 40 or SpindleOff) _turning = code == SpindleOff ? null : code;
            else if (code is 70 or CoolantOn or CoolantOff) _coolant = code != CoolantOff;
            else if (code is >= 620 and <= OutputOff && block['P'] == profile.ToolOutput - 1) IsOutputOn = (code is 620 or OutputOn) != profile.ToolActiveLow;
            if (RequiredInstead(code, block['P']) is { } expected) terms?.AddDifference(line, Spelled(code, block['P']), expected);
            if (_isSwitched && IsOn != wasOn) Await(IsOn ? profile.ToolSettleSeconds : profile.OffSettleSeconds, line);
            else if (profile.Spindle is { } spindle && Turns && !turned) Await(spindle.SpinUpSeconds, line);
        }
    }

    /// <summary>G4.</summary>
    public void Wait(double seconds, int line)
    {
        if (_due == 0.0 && _waited == 0.0) _line = line;
        _waited += seconds;
    }

    /// <summary>Called when an axis moves or the program ends: before this, the program must have waited for the last switch, and for nothing else.</summary>
    public void EndWait()
    {
        if (Math.Abs(_waited - _due) > Decimals) terms?.AddDifference(_line, $"G4 P{NumberText.Rounded(_waited, 4)}", $"G4 P{NumberText.Rounded(_due, 4)}");
        (_waited, _due) = (0.0, 0.0);
    }

    /// <summary>Called for a cut: checks that the spindle or laser runs at the requested speed.</summary>
    public void Cut(int line)
    {
        if (terms is null || !(profile.Spindle is not null || (_isSwitched && IsRequired("m3")))) return;
        if (!(Math.Abs((_speed ?? double.NaN) - terms.Required.SpindleSpeed) <= Decimals)) terms.AddDifference(line, _speed is { } speed ? $"S{NumberText.Rounded(speed, 4)}" : Wording.Get("GcodeReader.NoSpeed"), $"S{NumberText.Rounded(terms.Required.SpindleSpeed, 4)}");
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
            Clockwise => profile.Spindle is not null || (_isSwitched && IsRequired("m3")),
            CoolantOn => _isSwitched && IsRequired("m8"),
            OutputOn or OutputOff => _isSwitched && IsRequired("m64") && output == profile.ToolOutput - 1,
            _ => false,
        };
        if (isAsked) return null;
        if (profile.Spindle is not null && code is 40) return "M3";
        if (!_isSwitched) return Wording.Get("GcodeReader.NoCode");
        return terms.Required.ToolSwitch switch { "m8" => "M8, M9", "m64" => string.Create(CultureInfo.InvariantCulture, $"M64 P{profile.ToolOutput - 1}, M65 P{profile.ToolOutput - 1}"), _ => "M3, M5" };
    }

    private static string Spelled(int code, double? output) => code is >= 620 and <= OutputOff ? $"M{NumberText.Rounded(code / 10.0, 4)} P{NumberText.Rounded(output ?? 0.0, 4)}" : $"M{NumberText.Rounded(code / 10.0, 4)}";
}
