using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Tests.Commands.Trajectories;

/// <summary>The commands of paper 004 and of the plug-in (sace-xps-agie.md 1.1). The drawing has a line A1 (0,0 to 10,0), an arc A2, a circle A3 (20,5
/// radius 3) and a square A4 (30,0 side 8).</summary>
public class SaceCommandTests
{
    [Fact]
    public async Task SACEPATH_follows_every_contour_and_is_one_step_that_undoes()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEPATH", "ALL", "");
        var names = All(talk).Select(one => one.Name).ToList();

        Assert.Equal(["traj0_path", "traj1_path", "traj2_path", "traj3_path", "traj4_path", "traj5_path", "traj6_path"], names); // the square ends at its corners
        Assert.Equal(10.0 + (4.0 * 110.0 * Math.PI / 180.0) + (6.0 * Math.PI) + 32.0, All(talk).Sum(one => one.Curve.Length), precision: 9);
        Assert.All(All(talk), one => Assert.InRange(one.Curve.VerifiedBound, 0.0, 0.001));
        Assert.Contains("A3", All(talk).Single(one => one.Curve.Closed).Handles);
        Assert.True(talk.Session.Document.IsEdited);
        await talk.TypeAsync("U");
        Assert.Empty(All(talk));
        await talk.TypeAsync("REDO");
        Assert.Equal(names, All(talk).Select(one => one.Name));
    }

    /// <summary>"One entity only, no joining" (sace-xps-agie.md 1.4).</summary>
    [Fact]
    public async Task Objects_are_joined_to_contours_first()
    {
        await using var talk = Drawn(new DrawingBuilder().Line(0, 0, 10, 0).Arc(10, 2, 2, 270, 360).Line(12, 2, 12, 9));
        await talk.TypeAsync("SACEPATH", "ALL", "");
        var one = Assert.Single(All(talk));

        Assert.Equal(17.0 + Math.PI, one.Curve.Length, precision: 9);
        Assert.Equal(["A1", "A2", "A3"], one.Handles);
    }

    [Fact]
    public async Task Corners_are_ends_or_rounded_within_the_error()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACECORNERS", "Continuous", "SACEPATH", "H", "A4", "");
        var one = Assert.Single(All(talk));

        Assert.True(one.Curve.Closed);
        Assert.Equal(32.0, one.Curve.Length, precision: 9);
        Assert.InRange(one.Curve.VerifiedBound, 1e-6, 0.001);
    }

    /// <summary>"Cancel at SACESetMaxError sets eps = 0" (sace-xps-agie.md 1.4).</summary>
    [Fact]
    public async Task A_prompt_that_is_cancelled_or_answered_with_nothing_usable_changes_nothing()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACESETMAXERROR");
        await talk.Session.CancelAsync();
        await talk.TypeAsync("SACESETMAXERROR", "0", "-1", "nan");
        await talk.Session.CancelAsync();

        Assert.Equal(new TrajectorySettings(), talk.State.Sidecar.Trajectories.Settings);
        Assert.DoesNotContain(talk.Session.Document.UndoNames, name => name.StartsWith("SACE", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Error_density_steps_and_height_are_those_of_the_next_trajectories_and_undo()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACESETMAXERROR", "0.004", "SACESETZPLANE", "-0.5", "SACEPATH", "H", "A3", "", "SACETOGGLEDYNAMICDENSITY", "SACESETSTATICSEGMENTLENGTH", "0.25", "SACEPATH", "H", "A3", "");
        var (fine, equal) = (All(talk)[0], All(talk)[1]);

        Assert.Equal((0.004, -0.5, null), (fine.MaxErrorMm, fine.Curve.Z, fine.SegmentLengthMm));
        Assert.InRange(fine.Curve.VerifiedBound, 0.001, 0.004);
        Assert.Equal((0.25, (int)Math.Ceiling(6.0 * Math.PI / 0.25) + 1), (equal.SegmentLengthMm, equal.Curve.Points));
        await talk.TypeAsync("U", "U", "U");
        Assert.True(talk.State.Sidecar.Trajectories.Settings.DynamicDensity);
    }

    [Theory]
    [InlineData("20,5", 5.0)] // inside: a smaller circle
    [InlineData("40,40", 7.0)]
    [InlineData("In", 5.0)]
    [InlineData("Out", 7.0)]
    public async Task SACEOFFSET_runs_at_the_removal_radius_on_the_side_of_the_point(string side, double diameter)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEOFFSET", "H", "A3", "", "0.5", side);
        var one = Assert.Single(All(talk));

        Assert.Equal("traj0_offset-0", one.Name);
        Assert.Equal(diameter * Math.PI, one.Curve.Length, precision: 9);
    }

    [Theory]
    [InlineData("5,2", 1.0)]
    [InlineData("5,-2", -1.0)]
    [InlineData("-3,1", 1.0)] // beyond the end
    public async Task An_open_contour_is_offset_on_the_side_of_the_point(string side, double y)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEOFFSET", "H", "A1", "", "1", side);

        Assert.All(Assert.Single(All(talk)).Curve.Lines, place => Assert.Equal(y, place.Y, precision: 9));
    }

    /// <summary>Paper 004: decreasing offsets, the last at the tool radius; offsets r + (n-1) step, ..., r.</summary>
    [Fact]
    public async Task SACEUNIFORMOFFSET_comes_nearer_pass_by_pass_and_ends_at_the_removal_radius()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEUNIFORMOFFSET", "H", "A3", "", "0.5", "0.25", "4", "Out");

        Assert.Equal(["traj0_offset0-0", "traj1_offset1-0", "traj2_offset2-0", "traj3_offset3-0"], All(talk).Select(one => one.Name));
        Assert.Equal([4.25, 4.0, 3.75, 3.5], All(talk).Select(one => Math.Round(one.Curve.Length / (2.0 * Math.PI), 9)));
    }

    /// <summary>The plug-in's: r, r + step, ... up to the largest; one near the largest becomes the largest less r.</summary>
    [Theory]
    [InlineData("0.5", "0.5", "2", new[] { 0.5, 1.0, 1.5, 2.0 })]
    [InlineData("0.5", "0.4", "2", new[] { 0.5, 0.9, 1.3, 1.5 })]
    [InlineData("0.5", "1", "0.5", new[] { 0.5 })]
    [InlineData("0.5", "0.1", "0.7", new[] { 0.5, 0.7 })]
    public async Task SACECONSTANTOFFSETS_goes_away_as_the_plug_in_does(string radius, string step, string largest, double[] distances)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACECONSTANTOFFSETS", "H", "A3", "", radius, step, largest, "Out");

        Assert.Equal(distances, All(talk).Select(one => Math.Round((one.Curve.Length / (2.0 * Math.PI)) - 3.0, 9)));
    }

    [Fact]
    public async Task SACEDEEPENGRAVING_repeats_the_curve_down_to_the_final_depth()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACESETZPLANE", "2", "SACEDEEPENGRAVING", "H", "A3", "", "0.3", "1");

        Assert.Equal([2.0, 1.7, 1.4, 1.1, 1.0], All(talk).Select(one => Math.Round(one.Curve.Z, 9)));
        Assert.Single(All(talk).Select(one => one.Curve.VerifiedBound).Distinct());
    }

    [Fact]
    public async Task SACEHELICALDRILL_bores_down_and_goes_once_round_at_the_bottom()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEHELICALDRILL", "20,5", "1.25", "0.25", "1", "0.3", "");
        var curve = Assert.Single(All(talk)).Curve;
        var heights = Enumerable.Range(1, curve.Points).Select(curve.HeightAt).ToList();

        Assert.Equal(5 * 2.0 * Math.PI, curve.Length, precision: 9); // four turns of 0.25, and the bottom
        Assert.Equal((0.0, -1.0), (heights[0], heights[^1]));
        Assert.Equal(heights.OrderDescending(), heights);
        Assert.Equal((curve.Points - 1) / 5, heights.Count(height => height == -1.0) - 1);
        Assert.InRange(curve.VerifiedBound, 1e-6, 0.001);
        Assert.All(curve.Lines, place => Assert.InRange(place.DistanceTo(new Point2D(20.0, 5.0)), 0.9995, 1.0005));
        Assert.Contains("is too small", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SACEHELICALDRILL", "20,5", "0.2", "0.25")).Message, StringComparison.Ordinal);
    }

    /// <summary>"SACEShowTrajectories prints the type name of the list" (sace-xps-agie.md 1.1).</summary>
    [Fact]
    public async Task SACESHOWTRAJECTORIES_lists_names_points_bound_and_ratio()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "SACESHOWTRAJECTORIES");
        var one = Assert.Single(All(talk));

        Assert.Contains($"traj0_path: {one.Curve.Points} points, length 18.85 mm, maximum error 0.000", talk.Said, StringComparison.Ordinal);
        Assert.Contains("1 trajectory in the list.", talk.Said, StringComparison.Ordinal);
        Assert.DoesNotContain("List`1", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_last_or_all_are_deleted_and_numbers_go_on()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "SACEPATH", "H", "A1", "", "SACEDELETELASTTRAJECTORY");
        Assert.Equal(["traj0_path"], All(talk).Select(one => one.Name));
        await talk.TypeAsync("SACEPATH", "H", "A1", "");
        Assert.Equal(["traj0_path", "traj2_path"], All(talk).Select(one => one.Name));
        await talk.TypeAsync("SACEDELETEALLTRAJECTORIES");
        Assert.Empty(All(talk));
        await talk.TypeAsync("U");
        Assert.Equal(2, All(talk).Count);
    }

    [Fact]
    public async Task One_trajectory_is_renamed_raised_made_anew_moved_and_deleted_each_as_a_step()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "SACEPATH", "H", "A1", "");
        await talk.TypeAsync("SACEEDITTRAJECTORY", "traj0_path", "Name", "ring", "SACEEDITTRAJECTORY", "ring", "Z", "-2", "SACEEDITTRAJECTORY", "ring", "Error", "0.01", "SACEEDITTRAJECTORY", "ring", "DOwn");
        var ring = All(talk)[1];

        Assert.Equal(("ring", -2.0, 0.01), (ring.Name, ring.Curve.Z, ring.MaxErrorMm));
        Assert.InRange(ring.Curve.VerifiedBound, 0.001, 0.01);
        await talk.TypeAsync("SACEEDITTRAJECTORY", "ring", "Delete");
        Assert.Equal(["traj1_path"], All(talk).Select(one => one.Name));
        await talk.TypeAsync("U", "U", "U", "U");
        Assert.Equal(("ring", 0.0), (All(talk)[0].Name, All(talk)[0].Curve.Z));
        Assert.Contains("Trajectory ring already exists", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SACEEDITTRAJECTORY", "traj1_path", "Name", "ring")).Message, StringComparison.Ordinal);
        Assert.Contains("is not a valid name", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SACEEDITTRAJECTORY", "traj1_path", "Name", "../x")).Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task SACEEXPORTTRAJECTORIES_writes_a_file_for_each_and_asks_before_it_replaces()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "SACEPATH", "H", "A1", "", "SACEEXPORTTRAJECTORIES", "Sace", "out");
        var lines = await File.ReadAllTextAsync(talk.PathOf("out/traj1_path.txt"));

        Assert.Equal("-10, 0, 0\r\n0, 0, 0\r\n10, 0, 0\r\n20, 0, 0\r\n", lines);
        Assert.Equal(["traj0_path.txt", "traj1_path.txt", "trajectories.json"], Directory.GetFiles(talk.PathOf("out")).Select(Path.GetFileName).Order(StringComparer.Ordinal));
        Assert.Equal(2, All(talk).Count);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SACEEXPORTTRAJECTORIES", "Xps-spline", "out", "N"));
        Assert.Equal(lines, await File.ReadAllTextAsync(talk.PathOf("out/traj1_path.txt")));
        await talk.TypeAsync("SACEEXPORTTRAJECTORIES", "Xps-spline", "out", "Y");
        Assert.StartsWith("-10,0,0\n0,0,0\n", await File.ReadAllTextAsync(talk.PathOf("out/traj1_path.txt")), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Equal_steps_that_do_not_keep_the_error_are_exported_only_when_that_is_asked_for()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACETOGGLEDYNAMICDENSITY", "SACESETSTATICSEGMENTLENGTH", "6", "SACEPATH", "H", "A3", "");

        Assert.Equal(CommandFailure.Drawing, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SACEEXPORTTRAJECTORIES", "Sace", "out", "")).Reason);
        Assert.Contains("TRJ0008", talk.Said, StringComparison.Ordinal);
        Assert.False(Directory.Exists(talk.PathOf("out")));
        await talk.TypeAsync("SACEEXPORTTRAJECTORIES", "Sace", "out", "Y");
        Assert.True(File.Exists(talk.PathOf("out/traj0_path.txt")));
        await talk.TypeAsync("SACEEXPORTTRAJECTORIES", "Linearc", "arcs"); // Computed from its source.
        Assert.True(File.Exists(talk.PathOf("arcs/traj0_path.txt")));
    }

    [Fact]
    public async Task A_helix_goes_to_controllers_of_splines_with_its_heights_and_to_no_other()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEHELICALDRILL", "20,5", "1.25", "0.25", "1", "0.5", "", "SACEEXPORTTRAJECTORIES", "Xps-spline", "out");
        var rows = await File.ReadAllLinesAsync(talk.PathOf("out/traj0_drill.txt"));

        Assert.Equal("0,0,0", rows[1]);
        Assert.EndsWith(",-1", rows[^2], StringComparison.Ordinal);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SACEEXPORTTRAJECTORIES", "Linearc", "flat"));
        Assert.False(Directory.Exists(talk.PathOf("flat")));
    }

    /// <summary>"No simulation" (sace-xps-agie.md 1.4): compares the machine's record with the source of the trajectories.</summary>
    [Fact]
    public async Task SACESIMULATE_tells_how_far_the_machine_was_from_what_the_trajectories_follow()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACESETMAXERROR", "0.02", "SACEPATH", "H", "A3", "", "SACEOFFSET", "H", "A4", "", "1", "Out");
        var result = await talk.TypeAsync("SACESIMULATE");
        var judged = talk.Session.Machine.Runs.LastRun!.Judgement;

        Assert.IsType<InputResult.Done>(result);
        Assert.InRange(judged.MaxDeviationMm!.Value, 0.004, 0.0228); // The error of the spline is visible, because only the source is the reference.
        Assert.Equal(0.0, judged.MissingLengthMm);
        Assert.Contains("proven", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task In_a_drawing_in_inches_typed_lengths_are_inches_and_trajectories_millimetres()
    {
        await using var talk = Drawn(new DrawingBuilder().Circle(2, 2, 1));
        talk.Session.Document.Commit("OPEN", talk.State with { Drawing = talk.State.Drawing! with { Unit = LengthUnits.FromInsUnits(1)! } });
        await talk.TypeAsync("SACEOFFSET", "ALL", "", "0.5", "2,2");

        Assert.Equal(25.4 * Math.PI, Assert.Single(All(talk)).Curve.Length, precision: 8);
    }

    [Fact]
    public async Task Islands_are_kept_clear_when_contours_are_offset_together()
    {
        await using var talk = Drawn(new DrawingBuilder().Circle(0, 0, 10).Circle(0, 0, 3));
        await talk.TypeAsync("SACEOFFSET", "ALL", "", "1", "6,0");

        Assert.Equal([4.0, 9.0], All(talk).Select(one => Math.Round(one.Curve.Length / (2.0 * Math.PI), 9)).Order());
    }

    private static IReadOnlyList<DocumentTrajectory> All(CommandTestSession talk) => talk.State.Sidecar.Trajectories.All;

    private static CommandTestSession Drawn(DrawingBuilder builder)
    {
        var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = builder.Build() });
        return talk;
    }
}
