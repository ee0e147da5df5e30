using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Operations;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Posts.Gcode;

/// <summary>The job as G-code, RS-274 as LinuxCNC and grbl read it (rs274-hpgl.md): absolute millimetres of the drawing in a work offset, lines as G1 and arcs
/// as G2 and G3 with their centres.</summary>
public sealed class GcodePost : IPost
{
    public string Name => "gcode";

    public string Summary => Wording.Get("GcodePost.Summary");

    public string FileExtension => ".ngc";

    public PostGeometry Geometry => PostGeometry.LinesAndArcs;

    public MotionStyle? Motion => null;

    public IReadOnlyList<PostOption> Options => GcodeChoice.Options;

    public string? OperationsRefusal => null;

    /// <summary>The S word of a switch is the power of a beam, unless it is the speed of a spindle.</summary>
    public OperationSupport SupportOf(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        var choice = GcodeChoice.Of(request);
        return new OperationSupport($"{Name} --tool-switch {choice.Switch}")
        {
            HasPower = request.Machine is { Height: null, Spindle: null } && choice.HasSpeed,
            HasOverscan = request.Machine is { Height: null, Spindle: null } && choice.Dialect.HasLaserMode && choice.Switch == GcodeChoice.ByDynamicPower,
        };
    }

    public PostOutput Write(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        if (request.Path.Strokes.Count == 0) return new PostOutput([], [DocumentRules.NothingToPost.At(default)]);
        var choice = GcodeChoice.Of(request);
        IReadOnlyList<Diagnostic> faults = [.. Unfit(choice, request.Machine), .. OfOperations(choice, request), .. Unwritable(request, new GcodeGrid(choice.Dialect.Decimals))];
        if (faults.Any(fault => fault.Severity == Severity.Error)) return new PostOutput([], faults);
        return new PostOutput([new GcodeProgram(choice, request).Write()], faults);
    }

    /// <summary>Options that the dialect does not have.</summary>
    private static IEnumerable<Diagnostic> Unfit(GcodeChoice choice, MachineProfile machine)
    {
        if (machine.Height is null && choice.Switch == GcodeChoice.ByOutput && !choice.Dialect.HasOutputs) yield return PostRules.NotInDialect.At(default, choice.Dialect.Name, $"--tool-switch {choice.Switch}");
        if (machine.Height is null && choice.Switch == GcodeChoice.ByDynamicPower && !choice.Dialect.HasLaserMode) yield return PostRules.NotInDialect.At(default, choice.Dialect.Name, $"--tool-switch {choice.Switch}");
        if (choice.Blend > 0.0 && !choice.Dialect.HasBlending) yield return PostRules.NotInDialect.At(default, choice.Dialect.Name, "--blend");
        if (machine.Height is null && machine.Spindle is not null && choice.HasSpeed) yield return PostRules.ToolAndSpindle.At(default);
    }

    /// <summary>How the tool is changed, and the speeds that the program cannot set: with another switch of the tool than M3 and M4 and without a spindle in
    /// the profile there is no S word.</summary>
    private static IEnumerable<Diagnostic> OfOperations(GcodeChoice choice, PostRequest request)
    {
        if (request.Operations is not { } operations) yield break;
        var changes = operations.Sections.Skip(1).Count(section => section.Repeat is null) + (choice.Dialect.HasToolChange ? 1 : 0);
        if (operations.ChangeTool) yield return OperationRules.ToolChanged.At(default, FactText.Of(changes), Wording.Get(choice.Dialect.HasToolChange ? "GcodePost.ByTable" : "GcodePost.ByHand"));
        foreach (var operation in operations.All.Where(operation => operation.Outputs.Count > 0 && !choice.Dialect.HasOutputs)) yield return OperationRules.LeftOut.At(default, "gcode", "outputs", operation.Title);
        if (request.Machine.Height is null && choice.Switch == GcodeChoice.ByDynamicPower)
        {
            // The beam is off while the machine is at rest.
            foreach (var operation in operations.All.Where(operation => operation.PierceSeconds > 0.0)) yield return OperationRules.NotInFormat.At(default, $"gcode --tool-switch {choice.Switch}", "pierce", operation.Title);
        }

        if (request.Machine is not { Height: null, Spindle: null } || choice.HasSpeed) yield break;
        foreach (var operation in operations.All)
        {
            if (operations.Plan.SpindleOf(operation) is { } speed) yield return OperationRules.SpindleByHand.At(default, operation.Title, FactText.Of(speed));
        }
    }

    /// <summary>Positions beyond the range of a number in the format, and heights that the machine cannot cut; each entity once.</summary>
    private static IEnumerable<Diagnostic> Unwritable(PostRequest request, GcodeGrid grid)
    {
        var (reported, isAnyBelow, drive) = (new HashSet<int>(), false, request.Machine.Height);
        foreach (var move in request.Path.Strokes.SelectMany(stroke => stroke.Moves))
        {
            isAnyBelow |= drive is not null && !(Math.Min(move.StartZ, move.EndZ) >= drive.CutDepth);
            var source = request.SourceOf?.Invoke(move.EntityIndex) ?? default;
            if ((Beyond(move, grid, source) ?? (drive is null ? null : CutHeights.Finding(move, drive, source))) is { } finding && reported.Add(move.EntityIndex)) yield return finding;
        }

        if (request.Operations is { } operations && BeamOverscan.BoundsOf(request.Path, operations.Passes) is { IsEmpty: false } ways && new[] { -ways.MinX, -ways.MinY, ways.MaxX, ways.MaxY }.Max() > GcodeGrid.Largest)
        {
            yield return PostRules.PlaceNotWritable.At(default, FactText.Of(ways.MinX), FactText.Of(ways.MinY), grid.Text(grid.Of(GcodeGrid.Largest)));
        }

        if (drive is not null && !isAnyBelow) yield return MotionRules.NoDepth.At(default);
    }

    private static Diagnostic? Beyond(in StrokeMove move, GcodeGrid grid, SourceRef source)
    {
        var box = move.Segment.Bounds;
        var largest = new[] { Math.Abs(box.MinX), Math.Abs(box.MinY), Math.Abs(box.MaxX), Math.Abs(box.MaxY) }.Max();
        return largest <= GcodeGrid.Largest ? null : PostRules.PlaceNotWritable.At(source, FactText.Of(move.Segment.Start.X), FactText.Of(move.Segment.Start.Y), grid.Text(grid.Of(GcodeGrid.Largest)));
    }
}
