using System.Globalization;
using System.Text;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Operations;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts.Gcode;

/// <summary>Writes one program: head, each stroke in its passes with the rapid before it, end. Modal words are written when they change, the axes of a move
/// always: grbl needs a position with every arc.</summary>
internal sealed class GcodeProgram(GcodeChoice choice, PostRequest request)
{
    /// <summary>Largest distance of chords from an arc that the controller cannot compute precisely, millimetres.</summary>
    private const double ChordError = 0.0005;

    private const int LongestComment = 40;

    private readonly StringBuilder _text = new();
    private readonly GcodeGrid _grid = new(choice.Dialect.Decimals);
    private readonly MachineProfile _machine = request.Machine;
    private GridPlace _place;
    private long _z;
    private double _feed;
    private double _cutFeed = request.Machine.FeedMmPerMinute;
    private double _plunge = request.Machine.Height?.PlungeMmPerMinute ?? 0.0;
    private double _speed = request.Operations?.SpeedOf(0, choice.SpindleSpeed) ?? choice.SpindleSpeed;
    private Operation? _operation;
    private int _outputs;

    /// <summary>The program starts and stops a spindle: that of the profile, or that of operations which state its speed on a machine whose tool is not a
    /// switch.</summary>
    private bool HasSpindle => _machine.Spindle is not null || (_machine.Height is not null && request.Operations is { StateSpindle: true });

    private bool ChangesTool => request.Operations is { ChangeTool: true };

    public string Write()
    {
        Head();
        for (var i = 0; i < request.Path.Strokes.Count; i++)
        {
            var stroke = request.Path.Strokes[i];
            Enter(stroke, i);
            if (_machine.Height is { } drive) foreach (var lift in CutHeights.PassHeights(stroke, drive)) CutWithAxis(stroke, drive, lift);
            else if (_operation is { Overscan: > 0.0 } fill) CutWithOverscan(stroke, fill.Overscan);
            else CutWithSwitch(stroke);
        }

        SwitchOutputs(0);
        if (HasSpindle) Line("M5");
        Line(choice.End.ToUpperInvariant());
        if (choice.Dialect.HasPercent) Line("%");
        return _text.ToString();
    }

    private void Head()
    {
        if (choice.Dialect.HasPercent) Line("%");
        Line($"(CncEngraver, {choice.Dialect.Name}, mm)");
        Line("G21 G17 G90 G91.1");
        Line("G94 G40 G49 G80");
        Line($"{choice.WorkOffset} {(choice.Blend > 0.0 ? $"G64 P{NumberText.Rounded(choice.Blend, 4)}" : "G61")}");
        if (_machine.Height is null) ToolOff();
        _outputs = choice.Dialect.HasOutputs ? _machine.OperationOutputs : 0; // they may be on
        SwitchOutputs(0);
        if (ChangesTool && choice.Dialect.HasToolChange) Load(request.Operations!.Sections[0].Tool);
        else if (request.Operations is { } operations) Comment(operations.Sections[0].Tool);
        if (_machine.Height is { } drive) Rise(drive);
        Turn();
    }

    /// <summary>Spindle on at the present speed, and the time that it needs for it.</summary>
    private void Turn()
    {
        if (!HasSpindle) return;
        Line($"M3 S{NumberText.Rounded(_speed, 4)}");
        Dwell(_machine.Spindle?.SpinUpSeconds ?? 0.0);
    }

    /// <summary>Another tool or a stop where a section begins, and the speeds of the stroke.</summary>
    private void Enter(ToolpathStroke stroke, int index)
    {
        (_cutFeed, _plunge) = (stroke.FeedMmPerMinute ?? _machine.FeedMmPerMinute, stroke.PlungeMmPerMinute ?? _plunge);
        if (request.Operations is not { } operations) return;
        var (operation, before) = (operations.OperationOf(index), _speed);
        _speed = operations.SpeedOf(index, choice.SpindleSpeed);
        if (index > 0 && operations.Sections.FirstOrDefault(section => section.FirstStroke == index) is { } section) Break(section);
        else if (_speed != before) Turn();
        if (operation != _operation) Line($"({Plain(operation.Title)})");
        _operation = operation;
        SwitchOutputs(stroke.Outputs);
    }

    /// <summary>The outputs of operations that are to be on; none in a dialect without them.</summary>
    private void SwitchOutputs(int wanted)
    {
        if (!choice.Dialect.HasOutputs) return;
        foreach (var output in OutputSwitch.Of(_outputs ^ wanted)) Line(OutputLine(output.Output, output.IsOn(wanted)));
        _outputs = wanted;
    }

    private void Break(ToolSection section)
    {
        SwitchOutputs(0);
        if (section.Repeat is { } repeat) Stop(section.Operations[0], repeat);
        else Change(section.Tool);
    }

    /// <summary>With the tool up and off: the operator continues the program.</summary>
    private void Stop(Operation operation, int repeat)
    {
        if (HasSpindle) Line("M5");
        Line($"({Plain($"Repeat {repeat.ToString(CultureInfo.InvariantCulture)} of {operation.Repeats.ToString(CultureInfo.InvariantCulture)} {operation.Title}")})");
        Line("M0");
        Turn();
    }

    /// <summary>With the tool up and off. The tip of the new tool is at another height, so the next move is up.</summary>
    private void Change(CuttingTool tool)
    {
        if (HasSpindle) Line("M5");
        if (choice.Dialect.HasToolChange)
        {
            Load(tool);
        }
        else
        {
            Comment(tool);
            Line("M0");
        }

        if (_machine.Height is { } drive) Rise(drive);
        Turn();
    }

    private void Load(CuttingTool tool)
    {
        Comment(tool);
        Line($"T{tool.Number.ToString(CultureInfo.InvariantCulture)} M6");
        if (_machine.Height is not null) Line("G43");
    }

    private void Comment(CuttingTool tool) => Line($"({Plain($"T{tool.Number.ToString(CultureInfo.InvariantCulture)} {tool.Name}".TrimEnd())})");

    /// <summary>A name as a comment of every controller: ASCII without brackets and commas. LinuxCNC shows what follows MSG and a comma.</summary>
    private static string Plain(string name)
    {
        var plain = string.Concat(name.Select(sign => char.IsAsciiLetterOrDigit(sign) || sign is ' ' or '-' or '.' or '/' ? sign : '_'));
        return plain.Length <= LongestComment ? plain : plain[..LongestComment];
    }

    private void CutWithSwitch(ToolpathStroke stroke)
    {
        Rapid(stroke.Start);
        ToolOn(stroke.PierceSeconds > 0.0);
        Dwell(_machine.ToolSettleSeconds + stroke.PierceSeconds);
        foreach (var move in stroke.Moves) Cut(move with { StartZ = 0.0, EndZ = 0.0 }, 0.0);
        ToolOff();
        Dwell(_machine.OffSettleSeconds);
    }

    /// <summary>Each line with its ways before and behind it: in laser mode S changes between motions without a stop, and S0 is a beam that is off.</summary>
    private void CutWithOverscan(ToolpathStroke stroke, double overscan)
    {
        var power = $" S{NumberText.Rounded(_speed, 4)}";
        foreach (var line in stroke.Moves.Select(move => move.Segment))
        {
            var (from, to) = BeamOverscan.Around(line, overscan);
            Rapid(from);
            Line("M4 S0");
            LineTo(_grid.Of(line.Start), 0, " S0");
            LineTo(_grid.Of(line.End), 0, power);
            LineTo(_grid.Of(to), 0, " S0");
            ToolOff();
        }
    }

    private void CutWithAxis(ToolpathStroke stroke, HeightDrive drive, double lift)
    {
        var above = lift - drive.CutDepth;
        Rapid(stroke.Start);
        Line($"G0 Z{_grid.Text(_z = _grid.Of(drive.RetractHeight))}");
        Plunge(_grid.Of(stroke.Moves[0].StartZ + above));
        Dwell(stroke.PierceSeconds);
        foreach (var move in stroke.Moves) Cut(move, above);
        Dwell(stroke.DwellSeconds);
        Rise(drive);
    }

    private void Rise(HeightDrive drive) => Line($"G0 Z{_grid.Text(_z = _grid.Of(drive.ClearanceHeight))}");

    private void Plunge(long z)
    {
        if (z != _z) Line($"G1 Z{_grid.Text(_z = z)}{Feed(_plunge)}");
    }

    private void Rapid(Point2D to)
    {
        _place = _grid.Of(to);
        Line($"G0 X{_grid.Text(_place.X)} Y{_grid.Text(_place.Y)}");
    }

    /// <summary>A gap before the move, within the join tolerance, is bridged by a line.</summary>
    private void Cut(in StrokeMove move, double above)
    {
        var segment = move.Segment;
        LineTo(_grid.Of(segment.Start), _grid.Of(move.StartZ + above));
        if (segment.Kind == SegmentKind.Line) LineTo(_grid.Of(segment.End), _grid.Of(move.EndZ + above));
        else if (IsStraight(segment.Arc)) LineTo(_grid.Of(segment.End), _z);
        else if (segment.Arc.Radius > choice.Dialect.LargestRadius) Chords(segment);
        else Arc(segment);
    }

    private void LineTo(GridPlace to, long z, string power = "")
    {
        if (to == _place && z == _z) return;
        var (from, start) = (_grid.Millimetres(_place), _z * _grid.Unit);
        (_place, var fall) = (to, start - (z * _grid.Unit));
        var speed = _cutFeed;
        if (_machine.Height is not null && fall > 0.0) speed = Math.Min(speed, _plunge * double.Hypot(from.DistanceTo(_grid.Millimetres(to)), fall) / fall);
        var height = z == _z ? "" : $" Z{_grid.Text(_z = z)}";
        Line($"G1 X{_grid.Text(to.X)} Y{_grid.Text(to.Y)}{height}{Feed(speed)}{power}");
    }

    /// <summary>An arc whose height over its chord is less than half a unit is its chord: rounded ends would change its direction arbitrarily.</summary>
    private bool IsStraight(ArcSegment arc) => Math.Abs(arc.Sweep.Degrees) < 180.0 && arc.Radius * (1.0 - Angle.FromDegrees(arc.Sweep.Degrees / 2.0).Cos()) < _grid.Unit / 2.0;

    private void Chords(in Segment segment)
    {
        var arc = segment.Arc;
        var count = (int)Math.Ceiling(Math.Abs(arc.Sweep.Radians) / Math.Sqrt(8.0 * ChordError / arc.Radius));
        for (var i = 1; i <= count; i++) LineTo(_grid.Of(i == count ? segment.End : arc.PointAt((double)i / count)), _z);
    }

    /// <summary>The centre is rounded as a position and written relative to the rounded start: the distances of both ends from it then differ by a few units of
    /// rounding.</summary>
    private void Arc(in Segment segment)
    {
        var (arc, centre, end) = (segment.Arc, _grid.Of(segment.Arc.Centre), segment.Kind == SegmentKind.Circle ? _place : _grid.Of(segment.End));
        var (i, j) = (centre.X - _place.X, centre.Y - _place.Y);
        if ((end == _place && Math.Abs(arc.Sweep.Degrees) < 180.0) || (i == 0 && j == 0)) return; // smaller than a unit
        _place = end;
        Line($"{(arc.Sweep.Degrees < 0.0 ? "G2" : "G3")} X{_grid.Text(end.X)} Y{_grid.Text(end.Y)} I{_grid.Text(i)} J{_grid.Text(j)}{Feed(_cutFeed)}");
    }

    private string Feed(double mmPerMinute)
    {
        if (mmPerMinute == _feed) return "";
        _feed = mmPerMinute;
        return $" F{NumberText.Rounded(mmPerMinute, 4)}";
    }

    /// <param name="isAtRest">The tool works before it moves: a controller in laser mode has a beam on only after G1, which needs a feed.</param>
    private void ToolOn(bool isAtRest) => Line(choice.Switch switch
    {
        GcodeChoice.BySpindle when isAtRest && choice.Dialect.HasLaserMode => $"G1 M3 S{NumberText.Rounded(_speed, 4)}{Feed(_cutFeed)}",
        GcodeChoice.ByDynamicPower => $"M4 S{NumberText.Rounded(_speed, 4)}",
        GcodeChoice.BySpindle => $"M3 S{NumberText.Rounded(_speed, 4)}",
        GcodeChoice.ByCoolant => "M8",
        _ => OutputLine(_machine.ToolOutput, !_machine.ToolActiveLow),
    });

    private void ToolOff() => Line(choice.Switch switch
    {
        GcodeChoice.BySpindle or GcodeChoice.ByDynamicPower => "M5",
        GcodeChoice.ByCoolant => "M9",
        _ => OutputLine(_machine.ToolOutput, _machine.ToolActiveLow),
    });

    /// <summary>G-code numbers outputs from 0.</summary>
    private static string OutputLine(int output, bool level) => $"{(level ? "M64" : "M65")} P{(output - 1).ToString(CultureInfo.InvariantCulture)}";

    private void Dwell(double seconds)
    {
        if (seconds > 0.0) Line($"G4 P{NumberText.Rounded(seconds, 4)}");
    }

    private void Line(string text) => _text.Append(text).Append('\n');
}
