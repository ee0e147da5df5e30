using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>The controller with its modes, and the model of the machine. The codes of a line are executed in the order of RS-274, independent of their order in
/// the line (rs274-hpgl.md 1.2).</summary>
internal sealed class GcodeMachine(ReplayRequest request, GcodeController controller)
{
    private const double MillimetresPerInch = 25.4;

    private readonly GcodeTracer _tracer = new(request);
    private readonly MachineProfile _profile = request.Machine;
    private readonly GcodeSwitches _switches = new(request.Machine, request.Requirements, request.Strokes, controller != GcodeController.Grbl);
    private readonly GcodeOverscan _overscan = new(request.Requirements, request.Strokes);
    private Vector3D _place = StartOf(request);
    private bool _knowsX;
    private bool _knowsY;
    private bool _knowsZ = request.Machine.Height is null;
    private double _unit = 1.0;
    private bool _isAbsolute = true;
    private bool _isCentreAbsolute;
    private int? _motion;
    private int? _workOffset;
    private GcodeBlend _blend = controller == GcodeController.Grbl ? GcodeBlend.Exact : GcodeBlend.Unbounded;
    private double _feed;
    private bool _hasTool;
    private bool _needsLength;

    /// <summary>The tool has just come to the work: an operation may require a wait.</summary>
    private bool _hasArrived;

    public bool HasMoved => _tracer.HasMoved;

    /// <summary>M2 or M30 has been executed.</summary>
    public bool HasEnded { get; private set; }

    /// <summary>Executes a line that complies with the rules.</summary>
    /// <returns>The reason why it cannot be executed; null when it was executed.</returns>
    public string? Execute(GcodeBlock block, int line)
    {
        if (block['F'] is { } feed) _feed = feed * _unit;
        if (Change(block) is { } unchanged) return unchanged;
        Switch(block, line);
        foreach (var code in block.Codes('G')) if (Mode(code) is { } fault) return fault;
        Control(block);
        if (block.Codes('G').Where(GcodeCodes.IsMotion).Select(code => (int?)code).FirstOrDefault() is { } motion) _motion = motion;
        if (block.Has("IJR") && _motion is not (20 or 30)) return Wording.Get("GcodeReader.ArcWordsWithoutArc");
        if ((block.Has("XYZ") || (block.Has("IJR") && _motion is 20 or 30)) && Move(block, line) is { } unmoved) return unmoved;
        return block.Codes('M').Any(code => code is 20 or 300) ? End(line) : null;
    }

    private static Vector3D StartOf(ReplayRequest request) => request.Machine.Scale.ToMillimetres(request.Start.X, request.Start.Y) is var start ? new Vector3D(start.X, start.Y, 0.0) : default;

    /// <summary>A change of the tool by M6 or at a stop: its tip is then at another height, as after G43, which takes its length from the tool table. At a stop
    /// between repeats the tool remains.</summary>
    /// <returns>Why the tool cannot be changed here; null otherwise.</returns>
    private string? Change(GcodeBlock block)
    {
        var (isStop, loads) = (block.Codes('M').Contains(GcodeCodes.Stop) && request.Strokes is { Tools.Count: > 1 }, block.Codes('M').Contains(GcodeCodes.ToolChange));
        _hasTool |= loads;
        _needsLength = (_needsLength || (loads && _profile.Height is not null)) && !block.Codes('G').Contains(GcodeCodes.ToolLength);
        if (block.Codes('G').Contains(GcodeCodes.ToolLength) && !_hasTool) return Wording.Get("GcodeReader.LengthWithoutTool");
        if (!isStop && !loads && !block.Codes('G').Contains(GcodeCodes.ToolLength)) return null;
        if ((_profile.Height is { } drive ? _knowsZ && _place.Z < drive.RetractHeight : _switches.IsOn) || (isStop && _switches.Turns)) return Wording.Get(isStop && !_switches.IsChangeNext ? "GcodeReader.StopInWork" : "GcodeReader.ToolChangeInWork");
        _knowsZ = _profile.Height is null || (isStop && !_switches.IsChangeNext);
        return null;
    }

    private void Switch(GcodeBlock block, int line)
    {
        var was = _switches.IsOn;
        _switches.Execute(block, line);
        if (block.Codes('G').Contains(GcodeCodes.Dwell)) _switches.Wait(block['P'] ?? 0.0, line);
        _hasArrived |= _profile.Height is null && _switches.IsOn && !was;
        if (_switches.IsOn != was) _tracer.Switch(_place, _switches.IsOn);
    }

    private string? Mode(int code)
    {
        if (GcodeCodes.IsWorkOffset(code))
        {
            if (_tracer.HasMoved && code != (_workOffset ?? GcodeCodes.UsualWorkOffset)) return Wording.Get("GcodeReader.WorkOffsetChanged");
            _workOffset = code;
        }

        _unit = code == GcodeCodes.Inch ? MillimetresPerInch : code == GcodeCodes.Millimetre ? 1.0 : _unit;
        _isAbsolute = code == GcodeCodes.Absolute || (code != GcodeCodes.Incremental && _isAbsolute);
        _isCentreAbsolute = code == GcodeCodes.AbsoluteCentre || (code != GcodeCodes.IncrementalCentre && _isCentreAbsolute);
        return null;
    }

    /// <summary>Lengths use the unit of the line, wherever the unit is in the line.</summary>
    private void Control(GcodeBlock block)
    {
        foreach (var code in block.Codes('G'))
        {
            if (code is GcodeCodes.ExactPath or GcodeCodes.ExactStop) _blend = GcodeBlend.Exact;
            else if (code == GcodeCodes.Blending) _blend = GcodeBlend.Of(block['P'], block['Q'], _unit);
        }
    }

    private string? Move(GcodeBlock block, int line)
    {
        if (_motion is null or GcodeCodes.NoMotion) return Wording.Get("GcodeReader.NoMotion");
        if (_motion != 0 && !(_feed > 0.0)) return Wording.Get("GcodeReader.NoFeed");
        if (_motion != 0 && _switches.HasSpindle && !_switches.Turns) return Wording.Get("GcodeReader.SpindleOff");
        if (!_isAbsolute && !(Knows('X', block) && Knows('Y', block) && Knows('Z', block))) return Wording.Get("GcodeReader.PositionUnknown");
        var to = new Vector3D(Coordinate(block['X'], _place.X), Coordinate(block['Y'], _place.Y), Coordinate(block['Z'], _place.Z));
        if (_profile.Height is null && to.Z != 0.0) return Wording.Get("GcodeReader.NoToolAxis");
        Judge(to, line);
        if (_motion is 20 or 30) return Turn(block, to, line);
        if (_motion != 0 && !SetKnown(block)) return Wording.Get("GcodeReader.PositionUnknown");
        if (_motion == 0 && !_knowsZ && !block.Has("Z")) return Wording.Get("GcodeReader.HeightUnknown");
        var (from, isKnown) = (_place, _knowsZ);
        SetKnown(block);
        _place = to;
        if (isKnown) _tracer.Line(from, to, new GcodeMotion(_switches.IsOn, _motion == 0 ? double.PositiveInfinity : _feed, _blend, line));
        return null;
    }

    /// <summary>Conditions of a motion: the frame of its position, completed waits, the tool's speed; with the tool off it is a rapid.</summary>
    private void Judge(Vector3D to, int line)
    {
        _switches.EndWait(WaitsBefore(to));
        _hasArrived = _profile.Height is { } axis && to.X == _place.X && to.Y == _place.Y && _place.Z >= axis.RetractHeight && to.Z < axis.RetractHeight;
        if (request.Requirements is not { } terms) return;
        var offset = GcodeCodes.WorkOffsetText(_workOffset ?? GcodeCodes.UsualWorkOffset);
        if (offset != terms.Required.WorkOffset) terms.AddDifference(line, offset, terms.Required.WorkOffset);
        if (_needsLength) terms.AddDifference(line, "G49", "G43");
        if (_profile.Height is null) Follow(to, line);
        if (_motion == 0 || (_profile.Height is null && !_switches.IsOn && _motion == 10)) return;
        if (_profile.Height is { } drive ? to.X == _place.X && to.Y == _place.Y && to.Z == drive.ClearanceHeight : !_switches.IsOn) terms.AddDifference(line, $"G{_motion / 10}", "G0");
        else _switches.Cut(line, request.Strokes?.Passing(new Point2D(to.X, to.Y), _profile.Height is null ? null : to.Z));
    }

    /// <summary>A motion of a tool that is switched.</summary>
    private void Follow(Vector3D to, int line)
    {
        var (start, end) = (new Point2D(_place.X, _place.Y), new Point2D(to.X, to.Y));
        if (_motion != 10) _overscan.End();
        else if (_switches.IsOn) _overscan.Cut(start, end, _feed, line);
        else _overscan.Pass(start, end, _feed, line);
    }

    /// <summary>The waits of operations before a motion: between the arrival of the tool at the work and the first move, and before the tool is taken
    /// away.</summary>
    private IReadOnlyList<double>? WaitsBefore(Vector3D to)
    {
        if (request.Strokes is not { } strokes) return null;
        if (_hasArrived) return strokes.WaitsAtStart(_place);
        return _profile.Height is { } drive && _place.Z < drive.RetractHeight && to.Z >= drive.RetractHeight ? strokes.WaitsAtEnd(_place) : null;
    }

    private string? Turn(GcodeBlock block, Vector3D to, int line)
    {
        if (!(_knowsX && _knowsY && _knowsZ)) return Wording.Get("GcodeReader.PositionUnknown");
        if (controller == GcodeController.Grbl && !block.Has("XY")) return Wording.Get("GcodeReader.ArcWithoutEnd");
        if (block.Has("R") == block.Has("IJ")) return Wording.Get("GcodeReader.CentreOrRadius");
        if (_isCentreAbsolute && block.Has("IJ") && !(block.Has("I") && block.Has("J"))) return Wording.Get("GcodeReader.AbsoluteCentreNeedsIAndJ");
        var (start, end, clockwise) = (new Point2D(_place.X, _place.Y), new Point2D(to.X, to.Y), _motion == 20);
        var (i, j) = ((block['I'] ?? 0.0) * _unit, (block['J'] ?? 0.0) * _unit);
        var centre = _isCentreAbsolute ? new Point2D(i, j) : new Point2D(start.X + i, start.Y + j);
        var arc = block['R'] is { } radius ? GcodeArc.ByRadius(start, end, radius * _unit, clockwise, controller, out var reason) : GcodeArc.ByCentre(start, end, centre, clockwise, controller, out reason);
        if (arc is not { } known) return reason;
        var from = _place;
        _place = to;
        _tracer.Arc(known, from, to, new GcodeMotion(_switches.IsOn, _feed, _blend, line));
        return null;
    }

    /// <summary>The program stops the spindle and the coolant itself; an output and a tool in the work keep their state.</summary>
    private string? End(int line)
    {
        HasEnded = true;
        _switches.End(line);
        _switches.EndWait();
        _overscan.End();
        if (_switches.IsOutputOn) return Wording.Get("GcodeReader.EndsWithToolOn");
        return _profile.Height is { } drive && _tracer.HasMoved && _place.Z < drive.RetractHeight ? Wording.Get("GcodeReader.EndsBelowRetractHeight") : null;
    }

    private bool Knows(char axis, GcodeBlock block) => block[axis] is null || (axis == 'X' ? _knowsX : axis == 'Y' ? _knowsY : _knowsZ);

    /// <summary>The axes named by the line have a known position from then on.</summary>
    /// <returns>True when all axes have a known position after this line.</returns>
    private bool SetKnown(GcodeBlock block)
    {
        (_knowsX, _knowsY, _knowsZ) = (_knowsX || block.Has("X"), _knowsY || block.Has("Y"), _knowsZ || block.Has("Z"));
        return _knowsX && _knowsY && _knowsZ;
    }

    private double Coordinate(double? word, double now) => word is not { } value ? now : _isAbsolute ? value * _unit : now + (value * _unit);
}
