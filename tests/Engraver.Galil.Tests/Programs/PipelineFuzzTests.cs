using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.EntityTables;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Generation;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Programs;

/// <summary> Damaged drawings through all stages to the motion program. More of them: ENGRAVER_FUZZ_CASES=1000000 dotnet test tests/Engraver.Galil.Tests -c
/// Release --filter PipelineFuzzTests; ENGRAVER_FUZZ_FIRST sets the first seed, ENGRAVER_FUZZ_LOG a file to which the number of finished cases is written after
/// every thousand. </summary>
public class PipelineFuzzTests
{
    private const double MaxError = 0.01;

    /// <summary>Small drawings, so that many can be damaged in a second.</summary>
    private const int LargestOriginal = 6_000;

    private const int MaxCurves = 500;

    private const int LoggedCases = 1_000;

    /// <summary>A drawing of this size never needs so many; more means that a stage does not end.</summary>
    private const int MaxSegments = 2_000_000;

    /// <summary>A case takes less than a hundredth of it, even on a busy machine: a longer time is an endless loop.</summary>
    private static readonly TimeSpan LongestPath = TimeSpan.FromMinutes(2);

    [Fact]
    public async Task No_damage_makes_a_stage_throw_or_run_on_for_ever()
    {
        var fuzzer = new DrawingFuzzer(Originals());
        var first = TestExtent.Number("ENGRAVER_FUZZ_FIRST", 1);
        var log = Environment.GetEnvironmentVariable("ENGRAVER_FUZZ_LOG");
        var cases = TestExtent.Cases(perCommit: 500, full: 40_000, "ENGRAVER_FUZZ_CASES");
        for (var seed = first; seed < first + cases; seed++)
        {
            var file = fuzzer.Case(seed);
            try
            {
                await Task.Run(() => Go(file, seed)).WaitAsync(LongestPath);
            }
            catch (Exception wrong)
            {
                var path = Path.Combine(AppContext.BaseDirectory, string.Create(CultureInfo.InvariantCulture, $"way-{seed}.dxf"));
                await File.WriteAllBytesAsync(path, file);
                throw new InvalidOperationException($"seed {seed}, written to {path}: {wrong.GetType().Name}: {wrong.Message}", wrong);
            }

            var done = seed - first + 1;
            if (log is not null && done % LoggedCases == 0) await File.AppendAllTextAsync(log, string.Create(CultureInfo.InvariantCulture, $"{done} cases from {first} on are done, none failed\n"));
        }
    }

    private static void Go(byte[] file, int seed)
    {
        var drawing = DxfReader.Read(file, "test.dxf", new DxfReadOptions(MaxExpandedCurves: MaxCurves, Cut: seed % 2 == 0 ? CutChoice.None : (CutChoice)31), CancellationToken.None);
        var analysed = ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, new LayerSelection([], [])));
        var options = UsualOptions.Sequencing with { ArcTolerance = seed % 3 == 0 ? MaxError : null, KeepDuplicates = seed % 5 == 0 };
        var sequence = Sequencer.Sequence(analysed, drawing, options);
        var toolpath = ToolpathPlanner.Plan(sequence, default, MaxError);
        Assert.Equal(sequence.Strokes.Count, toolpath.Strokes.Count);
        Assert.All(toolpath.Strokes, stroke => Assert.NotEmpty(stroke.Moves));
        var motion = MotionProgramGenerator.Generate(toolpath, MachineProfile.Default, new(MaxError, 0.0), drawing.SourceOf, seed % 2 == 0 ? MotionStyle.Continuous : MotionStyle.Calls);
        if (motion.Program is not { } program) Assert.Contains(motion.Diagnostics, finding => finding.Severity == Core.Diagnostics.Severity.Error);
        else Assert.InRange(program.SegmentCount, 0, MaxSegments);
    }

    private static List<byte[]> Originals()
    {
        var everything = OddDrawings.OneOfEverything();
        var files = new List<byte[]> { everything.ToAscii(), everything.ToBinary(oneByteCodes: false), DxfText.WithEntities([.. OddDrawings.Spline, .. OddDrawings.Ellipse, .. OddDrawings.FitSpline]).ToAscii() };
        files.AddRange(Directory.GetFiles(RepositoryFolder.Samples, "*.dxf").Order(StringComparer.Ordinal).Select(File.ReadAllBytes).Where(file => file.Length <= LargestOriginal));
        return files;
    }
}
