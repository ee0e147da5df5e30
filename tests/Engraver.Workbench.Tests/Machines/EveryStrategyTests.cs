using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.TestKit;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>The main job three ways over each kind of link, judged by every motor sample of the simulated controller.</summary>
/// <remarks>The fast subset runs each foreign drawing and each sample in one mode over one link, so that with the corpus every mode is run over every link (on
/// <c>sim:</c> the console's <c>SampleRunTests</c> run each sample in every mode); <c>./test --full</c> every combination.</remarks>
public class EveryStrategyTests
{
    /// <summary>2.5 counts at 1000 counts/mm and the default curve tolerance, millimetres.</summary>
    private const double AllowedDeviation = 0.0025 + 0.001;

    private static readonly string[] s_links = ["sim", "serial", "tcp"];

    /// <summary>In this order the longest jobs of the fast subset use the cheapest link, and short ones over the serial line, which transfers single bytes; the
    /// console's <c>NetworkRunTests</c> cover streaming over TCP.</summary>
    private static readonly string[] s_samples = ["clock-dial.dxf", "pcb-outline.dxf", "nameplate.dxf", "paper-001.dxf", "gasket.dxf", "nested-logo.dxf", "label-plate.dxf", "operation-plate.dxf", "finished-plate.dxf"];

    /// <summary>Ten drawings by nine programs: arcs, ellipses, splines, bulges, old polylines; inches, no unit; blocks nested, in arrays, turned and
    /// mirrored; binary; versions from R10 to 2013; in such an order too.</summary>
    private static readonly string[] s_corpus =
    [
        "LibreCAD+LibreCAD/ef60f822f95b_Transform-output.dxf",
        "joco-nz+dxf2gcode-plasma/29a098baf38b_problem_with_arc_in_blockqcad.dxf",
        "qcad+qcad/30ad99da4be0_ArcCircleArea.dxf",
        "qcad+qcad/5806efabed39_splines.dxf",
        "KLayout+klayout/633e57271740_dxf5_au.dxf",
        "panzergame+dxfplotter/503f79462339_branche.dxf",
        "openscad+openscad/8d1d4192a988_transform-insert.dxf",
        "mikedh+trimesh/6afcde272958_ae.r2010b.dxf",
        "LibreDWG+libredwg/2c8bc7de7ab9_entities-2d.dxf",
        "qcad+qcad/f3a3b16e210a_ExplodeTest02_000.dxf",
    ];

    public static TheoryData<string, JobMode, string> Samples => Listed(TestExtent.InTurn(s_samples, Enum.GetValues<JobMode>(), s_links));

    public static TheoryData<string, JobMode, string> Corpus => Listed(TestExtent.InTurn(s_corpus, Enum.GetValues<JobMode>(), s_links));

    [Fact]
    public void No_sample_is_left_out() =>
        Assert.Equal(Directory.GetFiles(RepositoryFolder.Samples, "*.dxf").Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal), s_samples.Order(StringComparer.Ordinal));

    [Theory]
    [MemberData(nameof(Samples))]
    public Task Every_sample_is_cut_on_its_lines_and_whole(string name, JobMode mode, string link) => AssertCutAsync(Path.Combine(RepositoryFolder.Samples, name), mode, link);

    [CorpusTheory]
    [MemberData(nameof(Corpus))]
    public Task Drawings_of_other_programs_are_cut_on_their_lines_and_whole(string name, JobMode mode, string link) =>
        AssertCutAsync(Path.Combine(RepositoryFolder.Corpus!, "files", name), mode, link);

    private static async Task AssertCutAsync(string drawing, JobMode mode, string link)
    {
        await using var controller = await ServedController.StartAsync(link);
        var (result, judged) = await controller.CutAsync(drawing, mode);

        Assert.Equal((JobOutcome.Complete, ""), (result.Outcome, string.Join('\n', result.NotRestored)));
        Assert.InRange(judged.MaxDeviationMm!.Value, 0.0, AllowedDeviation);
        Assert.Equal((0.0, "record"), (judged.MissingLengthMm, judged.Source));
        Assert.Equal(result.SegmentsSent, result.SegmentsExecuted);
        Assert.Equal((0, 0), (result.Underruns, result.Rejected));
    }

    private static TheoryData<string, JobMode, string> Listed(IEnumerable<(string Drawing, JobMode Mode, string Link)> combinations)
    {
        var runs = new TheoryData<string, JobMode, string>();
        foreach (var (drawing, mode, link) in combinations) runs.Add(drawing, mode, link);
        return runs;
    }
}
