using System.Diagnostics;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Sequencing;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>The trajectories of a drawing's contours, with the names of their files.</summary>
/// <param name="Trajectories">In the order of cutting.</param>
/// <param name="Diagnostics">Findings of all stages.</param>
public sealed record TrajectoryDrawing(IReadOnlyList<NamedTrajectory> Trajectories, IReadOnlyList<Diagnostic> Diagnostics)
{
    /// <param name="settings">Layers, units, tolerances, order; the machine's feed and acceleration are used by formats with velocities.</param>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static TrajectoryDrawing Create(Drawing drawing, DrawingSettings settings, TrajectoryRequest request)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(request);
        if (settings.Operations is not null) return new TrajectoryDrawing([], [.. drawing.Diagnostics, OperationRules.NotPosted.At(default, "trajectory", Wording.Get("PostedProgram.WithoutOperations"))]);
        var ordered = JobPreparation.To<OrderedJob>(drawing, settings);
        if (CheckStage.TextFaultsOf(ordered) is { Count: > 0 } faults) return new TrajectoryDrawing([], [.. drawing.Diagnostics, .. JobPreparation.Findings(ordered), .. faults]);
        (drawing, var sequence) = (ordered.Drawing, ordered.Sequence);
        var work = new TrajectoryCollector(drawing, settings, request);
        if (request.Offset is { } offset) work.AddOffsets(sequence, offset);
        else work.AddPaths(sequence);
        if (sequence.Contours == 0 && !DrawingFile.IsUnreadable(drawing)) work.Findings.Add(DocumentRules.NothingToPost.At(default));
        return new TrajectoryDrawing(work.Results, [.. drawing.Diagnostics, .. JobPreparation.Findings(ordered), .. sequence.Diagnostics, .. ordered.Cut.FindingsBeside(sequence), .. work.Findings]);
    }

    private sealed class TrajectoryCollector(Drawing drawing, DrawingSettings settings, TrajectoryRequest request)
    {
        private readonly TrajectoryOptions _options = new(settings.MaxErrorMm) { SegmentLength = request.SegmentLength, Corners = request.Corners, Z = request.Z };
        private readonly TrajectoryMotion _motion = TrajectoryMotion.Of(settings.Machine);

        public List<NamedTrajectory> Results { get; } = [];

        public List<Diagnostic> Findings { get; } = [];

        public void AddPaths(SequencingResult sequence)
        {
            foreach (var stroke in sequence.Strokes) Add([.. stroke.Moves.Select(move => move.Segment)], stroke.Closed, stroke.Moves, number => $"traj{number}_path");
        }

        /// <summary>Outermost first, so that the last pass is at the offset itself; each pass is computed from the drawing.</summary>
        public void AddOffsets(SequencingResult sequence, TrajectoryOffset offset)
        {
            IReadOnlyList<OffsetContour> contours = [.. sequence.Strokes.Select(stroke => new OffsetContour([.. stroke.Moves.Select(move => move.Segment)], stroke.Closed))];
            var options = OffsetOptions.Round(settings.MaxErrorMm);
            for (var pass = 0; pass < offset.Passes; pass++)
            {
                var distance = offset.Distance + ((offset.Passes - 1 - pass) * offset.Step);
                var result = ContourOffset.Offset(contours, distance, offset.Side, options);
                Findings.AddRange(OffsetDrawing.Findings(result, contours.Count, distance));
                var (loop, of) = (0, offset.Passes > 1 ? $"_offset{pass}-" : "_offset-");
                foreach (var one in result.Loops) Add(one.Segments, one.Closed, [], number => $"traj{number}{of}{loop++}");
            }
        }

        private void Add(IReadOnlyList<Segment> contour, bool closed, IReadOnlyList<StrokeMove> moves, Func<int, string> name)
        {
            var start = Stopwatch.GetTimestamp();
            var result = TrajectoryFiles.Write(contour, closed, _options, request.Format, _motion);
            var seconds = Stopwatch.GetElapsedTime(start).TotalSeconds / Math.Max(1, result.Files.Count);
            foreach (var file in result.Files)
            {
                var named = new NamedTrajectory(name(Results.Count) + ".txt", file, HandleOf(file.Source[0], moves), seconds);
                Results.Add(named);
                Findings.AddRange(TrajectoryFindings.LimitsOf(file, named.FileName, _motion));
                if (file.VerifiedBound > settings.MaxErrorMm) Findings.Add(TrajectoryRules.StepsRefused.At(default, named.FileName, FactText.Of(file.VerifiedBound), FactText.Of(settings.MaxErrorMm)));
            }

            Findings.AddRange(TrajectoryFindings.NotKept(result.Unproven, settings.MaxErrorMm));
        }

        /// <summary>Handle of the source entity of the first segment of a trajectory; null for an offset.</summary>
        private string? HandleOf(Segment first, IReadOnlyList<StrokeMove> moves)
        {
            var found = moves.Where(move => move.Segment.Start == first.Start).Concat(moves).Select(move => (int?)move.EntityIndex).FirstOrDefault();
            return found is { } entity ? drawing.SourceOf(entity).Handle : null;
        }
    }
}
