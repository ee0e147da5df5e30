using System.Text.Json.Nodes;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Tests.Commands.Trajectories;

/// <summary>Trajectories whose objects were edited are reported, and recomputed by SACEUPDATETRAJECTORIES. The drawing: a line A1, an arc A2, a circle A3 (20,5
/// radius 3), a square A4 (30,0 side 8).</summary>
public class TrajectoryEditTests
{
    [Fact]
    public async Task A_moved_circle_is_followed_again_under_the_same_name_height_and_error()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "SACEEDITTRAJECTORY", "traj0_path", "Name", "ring", "SACEEDITTRAJECTORY", "ring", "Z", "-2", "SACEEDITTRAJECTORY", "ring", "Error", "0.01", "SACEPATH", "H", "A1", "");
        Assert.Empty(Stale(talk));
        await talk.TypeAsync("MOVE", "H", "A3", "", "0,0", "5,1");
        Assert.Equal(["ring"], Stale(talk));
        await talk.TypeAsync("U");
        Assert.Empty(Stale(talk)); // Back at its old position.
        await talk.TypeAsync("REDO", "SACESHOWTRAJECTORIES");
        Assert.Contains("Its objects have been edited since.", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("SACEUPDATETRAJECTORIES"));
        var ring = All(talk)[0];

        Assert.Equal(("ring", -2.0, 0.01, 2), (ring.Name, ring.Curve.Z, ring.MaxErrorMm, All(talk).Count));
        Assert.All(ring.Curve.Lines.Skip(1).SkipLast(1), place => Assert.InRange(place.DistanceTo(new Point2D(25, 6)), 2.99, 3.01));
        Assert.InRange(ring.Curve.VerifiedBound, 0.001, 0.01);
        Assert.Empty(Stale(talk));
        await talk.TypeAsync("U");
        Assert.Equal(["ring"], Stale(talk));
        await talk.TypeAsync("REDO", "SACEUPDATETRAJECTORIES");
        Assert.Contains("No objects of the trajectories have been edited", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Offsets_of_several_contours_keep_their_distance_and_side()
    {
        await using var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Circle(0, 0, 10).Circle(0, 0, 3).Build() });
        await talk.TypeAsync("SACEOFFSET", "ALL", "", "1", "6,0", "SCALE", "H", "A1", "", "0,0", "2");
        Assert.Equal(["traj0_offset-0", "traj1_offset-1"], Stale(talk)); // Also that of the hole, which was created with it.
        await talk.TypeAsync("SACEUPDATETRAJECTORIES");

        Assert.Equal([4.0, 19.0], All(talk).Select(one => Math.Round(one.Curve.Length / (2.0 * Math.PI), 9)).Order());
        Assert.Equal(["traj0_offset-0", "traj1_offset-1"], All(talk).Select(one => one.Name));
    }

    [Fact]
    public async Task Each_run_between_corners_takes_its_own_place_and_what_was_deleted_stays_so()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEDEEPENGRAVING", "H", "A4", "", "0.5", "0.5", "SACEEDITTRAJECTORY", "traj1_deep", "Delete", "ROTATE", "H", "A4", "", "30,0", "90", "SACEUPDATETRAJECTORIES");

        Assert.Equal(["traj0_deep", "traj2_deep", "traj3_deep", "traj4_deep", "traj5_deep", "traj6_deep", "traj7_deep"], All(talk).Select(one => one.Name));
        Assert.Equal([0.0, 0.0, 0.0, -0.5, -0.5, -0.5, -0.5], All(talk).Select(one => one.Curve.Z));
        Assert.All(All(talk), one => Assert.InRange(one.Curve.Lines.Skip(1).SkipLast(1).Max(place => place.X), 22.0 - 1e-9, 30.0 + 1e-9));
        Assert.Empty(Stale(talk));
    }

    [Fact]
    public async Task A_contour_that_has_other_corners_now_gets_as_many_trajectories_as_it_needs()
    {
        await using var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 10, 0).Line(10, 0, 20, 0).Build() });
        await talk.TypeAsync("SACEPATH", "ALL", "", "SACEPATH", "H", "A1", "");
        Assert.Equal(["traj0_path", "traj1_path"], All(talk).Select(one => one.Name)); // Tangent: one trajectory.
        await talk.TypeAsync("ROTATE", "H", "A2", "", "10,0", "90", "SACEUPDATETRAJECTORIES");

        Assert.Equal(["traj0_path", "traj2_path", "traj1_path"], All(talk).Select(one => one.Name));
        Assert.Equal([10.0, 10.0, 10.0], All(talk).Select(one => Math.Round(one.Curve.Length, 9)));
        Assert.Equal(3, talk.State.Sidecar.Trajectories.NextNumber);
    }

    [Fact]
    public async Task What_was_erased_is_told_and_its_trajectory_stays()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "SACEPATH", "H", "A1", "", "ERASE", "H", "A3", "");
        Assert.Equal(["traj0_path"], Stale(talk));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SACEUPDATETRAJECTORIES"));

        Assert.Contains("or no longer give a path: traj0_path.", talk.Said, StringComparison.Ordinal);
        Assert.Equal(2, All(talk).Count);
    }

    [Theory]
    [InlineData("SACEEXPORTTRAJECTORIES", "Sace", "out")]
    [InlineData("SACESIMULATE")]
    [InlineData("CNCCONNECT", "sim:", "CNCARM", "T", "Stream")]
    public async Task Before_they_are_written_or_run_it_is_said_which_no_longer_follow_the_drawing(params string[] command)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync(["SACEPATH", "H", "A3", "", "MOVE", "H", "A1", "", "0,0", "0,1", .. command]);
        Assert.DoesNotContain("edited", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync(["MOVE", "H", "A3", "", "0,0", "0,1", .. command, "Y"]);

        Assert.Contains("Trajectories that do not match the edited drawing: 1, the first is traj0_path", talk.Said, StringComparison.Ordinal);
    }

    /// <summary>A written drawing gives its objects new handles, which the sidecar refers to.</summary>
    [Fact]
    public async Task Saved_and_opened_they_still_know_their_objects()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "SACEOFFSET", "H", "A4", "", "1", "Out", "SAVEAS", "new.dxf", "SACEPATH", "H", "A1", "", "QSAVE", "OPEN", "new.dxf");

        Assert.Empty(Stale(talk));
        Assert.All(All(talk), one => Assert.NotNull(one.Origin));
        Assert.DoesNotContain("A3", All(talk)[0].Handles);
        Assert.Equal(talk.State.Drawing!.SourceOf(2).Handle, Assert.Single(All(talk)[0].Handles));
        await talk.TypeAsync("MOVE", "H", All(talk)[0].Handles[0], "", "0,0", "5,1", "SACEUPDATETRAJECTORIES");
        Assert.All(All(talk)[0].Curve.Lines.Skip(1).SkipLast(1), place => Assert.InRange(place.DistanceTo(new Point2D(25, 6)), 2.999, 3.001));
        await talk.TypeAsync("MOVE", "H", All(talk)[1].Handles[0], "", "0,0", "1,1", "QSAVE", "Y", "OPEN", "new.dxf");
        Assert.Equal(["traj1_offset-0"], Stale(talk)); // As saved.
        await talk.TypeAsync("SACEUPDATETRAJECTORIES");
        Assert.Equal(32.0 + (2.0 * Math.PI), All(talk)[1].Curve.Length, 6);
    }

    [Theory]
    [InlineData("drawn", "\"\"")]
    [InlineData("index", "4")]
    [InlineData("group", "-1")]
    [InlineData("side", "\"up\"")]
    [InlineData("offset", "0")]
    [InlineData("corners", "\"round\"")]
    public async Task An_origin_that_contradicts_itself_is_damage(string member, string value)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEOFFSET", "H", "A3", "", "1", "Out", "SAVEAS", "new.dxf");
        var path = talk.PathOf("new.dxf.engraver.json");
        var json = JsonNode.Parse(await File.ReadAllTextAsync(path))!;
        json["trajectories"]![0]!["made"]![member] = JsonNode.Parse(value);
        await File.WriteAllTextAsync(path, json.ToJsonString());
        await talk.TypeAsync("OPEN", "new.dxf");

        Assert.Contains("SID0001: new.dxf.engraver.json is damaged and was not used: trajectories[0].made", talk.Said, StringComparison.Ordinal);
    }

    /// <summary>Of version 1.0, which has no origin.</summary>
    [Fact]
    public async Task Without_an_origin_a_trajectory_is_never_called_stale()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "SAVEAS", "new.dxf");
        var path = talk.PathOf("new.dxf.engraver.json");
        var json = JsonNode.Parse(await File.ReadAllTextAsync(path))!;
        Assert.True(json["trajectories"]![0]!.AsObject().Remove("made"));
        json["version"] = "1.0";
        await File.WriteAllTextAsync(path, json.ToJsonString());
        await talk.TypeAsync("OPEN", "new.dxf", "MOVE", "ALL", "", "0,0", "1,1");

        Assert.Equal("traj0_path", Assert.Single(All(talk)).Name);
        Assert.Empty(Stale(talk));
    }

    private static IReadOnlyList<DocumentTrajectory> All(CommandTestSession talk) => talk.State.Sidecar.Trajectories.All;

    private static List<string> Stale(CommandTestSession talk)
    {
        var edits = new TrajectoryEdits(talk.State.Drawing!);
        return [.. All(talk).Where(edits.IsStale).Select(one => one.Name)];
    }
}
