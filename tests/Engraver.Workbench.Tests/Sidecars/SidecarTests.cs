using System.Text.Json;
using System.Text.Json.Nodes;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Sidecars;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Sidecars;

/// <summary>NAME.dxf.engraver.json (docs/sidecar.md): the data of a drawing is restored, and nothing is lost.</summary>
public class SidecarTests
{
    [Fact]
    public async Task Trajectories_of_every_kind_come_back_as_they_were()
    {
        await using var talk = await WithFileAsync();
        await talk.TypeAsync("SACEPATH", "ALL", "", "SACETOGGLEDYNAMICDENSITY", "SACEPATH", "ALL", "", "SACEHELICALDRILL", "20,5", "1.25", "0.25", "1", "0.5", "", "SACESETZPLANE", "-3", "QSAVE");
        var before = talk.State.Sidecar;
        Assert.False(talk.Session.Document.IsEdited);
        await talk.TypeAsync("CLOSE", "OPEN", "part.dxf");
        var after = talk.State.Sidecar;

        Assert.True(before.Trajectories.All.Count > 10);
        Assert.Equal(before.Trajectories.Settings, after.Trajectories.Settings);
        Assert.Equal(before.Trajectories.NextNumber, after.Trajectories.NextNumber);
        Assert.Equal(before.Trajectories.All.Select(Shown), after.Trajectories.All.Select(Shown));
        Assert.DoesNotContain("SID", talk.Said, StringComparison.Ordinal);
        Assert.False(talk.Session.Document.IsEdited);
    }

    [Fact]
    public async Task SAVEAS_writes_it_beside_the_new_drawing_and_without_trajectories_there_is_no_file()
    {
        await using var talk = await WithFileAsync();
        await talk.TypeAsync("SAVEAS", "bare.dxf");
        Assert.False(File.Exists(talk.PathOf("bare.dxf.engraver.json")));
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "SAVEAS", "new.dxf", "OPEN", "new.dxf");

        Assert.Equal("traj0_path", Assert.Single(talk.State.Sidecar.Trajectories.All).Name);
        Assert.DoesNotContain("SID", talk.Said, StringComparison.Ordinal);
        Assert.Empty(Directory.GetFiles(talk.PathOf("."), "*.tmp"));
    }

    [Fact]
    public async Task QSAVE_leaves_the_drawing_alone_when_only_trajectories_changed_and_asks_when_it_was_edited()
    {
        await using var talk = await WithFileAsync();
        var written = File.GetLastWriteTimeUtc(talk.PathOf("part.dxf"));
        var text = await File.ReadAllBytesAsync(talk.PathOf("part.dxf"));
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "QSAVE");
        Assert.Equal(written, File.GetLastWriteTimeUtc(talk.PathOf("part.dxf")));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("MOVE", "ALL", "", "0,0", "1,1", "QSAVE", "N"));
        Assert.Equal(text, await File.ReadAllBytesAsync(talk.PathOf("part.dxf")));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("QSAVE", "Y"));
        Assert.NotEqual(text, await File.ReadAllBytesAsync(talk.PathOf("part.dxf")));
        Assert.False(talk.Session.Document.IsEdited);
    }

    [Theory]
    [InlineData("{\"version\": \"1.0\", \"trajectories\": [{\"name\": \"a\"", "SID0001")]
    [InlineData("", "SID0001")]
    [InlineData("[]", "SID0001")]
    [InlineData("{\"trajectories\": []}", "SID0001")]
    [InlineData("{\"version\": \"1.0\", \"trajectories\": [null]}", "SID0001")]
    [InlineData("{\"version\": \"1.0\", \"trajectorySettings\": {\"maxError\": 0}}", "SID0001")]
    [InlineData("{\"version\": \"2.0\"}", "SID0002")]
    [InlineData("{\"version\": \"0.9\", \"trajectories\": 7}", "SID0002")]
    public async Task A_file_that_cannot_be_used_is_told_kept_and_never_overwritten(string text, string id)
    {
        await using var talk = await WithFileAsync(text);
        Assert.Contains(id, talk.Said, StringComparison.Ordinal);
        Assert.Contains("part.dxf.engraver.json", talk.Said, StringComparison.Ordinal);
        Assert.NotNull(talk.State.Drawing);

        await talk.TypeAsync("QSAVE"); // Nothing to save: the file is not touched.
        Assert.Equal(text, await File.ReadAllTextAsync(talk.PathOf("part.dxf.engraver.json")));
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "QSAVE");
        var kept = Assert.Single(Directory.GetFiles(talk.PathOf("."), "part.dxf.engraver.json.kept-*"));
        Assert.Equal(text, await File.ReadAllTextAsync(kept));
        Assert.Contains("SID0005", talk.Said, StringComparison.Ordinal);
        Assert.Contains("traj0_path", await File.ReadAllTextAsync(talk.PathOf("part.dxf.engraver.json")), StringComparison.Ordinal);
        await talk.TypeAsync("SACEPATH", "H", "A1", "", "QSAVE");
        Assert.Single(Directory.GetFiles(talk.PathOf("."), "*.kept-*")); // Written by this session by now.
    }

    [Fact]
    public async Task Members_of_a_newer_minor_version_and_of_other_programs_are_written_again()
    {
        await using var talk = await WithFileAsync();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "QSAVE");
        var path = talk.PathOf("part.dxf.engraver.json");
        var json = JsonNode.Parse(await File.ReadAllTextAsync(path))!;
        json["version"] = "1.7";
        json["pins"] = new JsonArray(1.5, "a");
        json["operations"] = new JsonObject { ["pocket"] = true };
        json["trajectories"]![0]!["colour"] = "red";
        await File.WriteAllTextAsync(path, json.ToJsonString());
        await talk.TypeAsync("OPEN", "part.dxf", "SACEPATH", "H", "A1", "", "SACEEDITTRAJECTORY", "traj0_path", "Z", "1", "QSAVE");
        using var after = JsonDocument.Parse(await File.ReadAllTextAsync(path));
        var root = after.RootElement;

        Assert.Equal(("1.7", 1.5, true), (root.GetProperty("version").GetString(), root.GetProperty("pins")[0].GetDouble(), root.GetProperty("operations").GetProperty("pocket").GetBoolean()));
        Assert.Equal(("red", 2), (root.GetProperty("trajectories")[0].GetProperty("colour").GetString(), root.GetProperty("trajectories").GetArrayLength()));
        Assert.Empty(Directory.GetFiles(talk.PathOf("."), "*.kept-*"));
    }

    /// <summary>An error bound in a file is verified again.</summary>
    [Theory]
    [InlineData("lines")]
    [InlineData("knots")]
    [InlineData("source")]
    public async Task The_bound_is_proven_again_when_the_file_is_read(string member)
    {
        await using var talk = await WithFileAsync();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "QSAVE");
        var path = talk.PathOf("part.dxf.engraver.json");
        var json = JsonNode.Parse(await File.ReadAllTextAsync(path))!;
        var one = json["trajectories"]![0]!;
        one["verifiedBound"] = 0.0;
        if (member == "lines") one["lines"]![5]![0] = one["lines"]![5]![0]!.GetValue<double>() + 0.5;
        if (member == "knots") one["knots"]![3] = 1e9;
        if (member == "source") one["source"]![0]!["arc"]![2] = 3.5;
        await File.WriteAllTextAsync(path, json.ToJsonString());
        await talk.TypeAsync("OPEN", "part.dxf");

        if (member == "lines") Assert.InRange(Assert.Single(talk.State.Sidecar.Trajectories.All).Curve.VerifiedBound, 0.3, 0.7);
        else Assert.Contains("SID0001: part.dxf.engraver.json is damaged and was not used: trajectories[0]", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_drawing_that_was_changed_elsewhere_is_told()
    {
        await using var talk = await WithFileAsync();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "QSAVE");
        await talk.TypeAsync("MOVE", "H", "A3", "", "0,0", "1,0", "SAVEAS", "other.dxf");
        File.Copy(talk.PathOf("other.dxf"), talk.PathOf("part.dxf"), overwrite: true);
        await talk.TypeAsync("OPEN", "part.dxf");

        Assert.Contains("SID0004", talk.Said, StringComparison.Ordinal);
        Assert.Single(talk.State.Sidecar.Trajectories.All);
    }

    [Fact]
    public async Task Another_session_that_saved_meanwhile_loses_nothing()
    {
        await using var talk = await WithFileAsync();
        await talk.TypeAsync("SACEPATH", "H", "A3", "", "QSAVE");
        var path = talk.PathOf("part.dxf.engraver.json");
        var others = (await File.ReadAllTextAsync(path)).Replace("traj0_path", "theirs", StringComparison.Ordinal);
        await File.WriteAllTextAsync(path, others);
        await talk.TypeAsync("SACEPATH", "H", "A1", "", "QSAVE");

        Assert.Equal(others, await File.ReadAllTextAsync(Assert.Single(Directory.GetFiles(talk.PathOf("."), "*.kept-*"))));
    }

    /// <summary>Every truncation of a file, as after a crash of another program, and every changed byte: reported or used, without an exception.</summary>
    [Fact]
    public async Task No_damage_of_a_file_breaks_the_reader()
    {
        await using var talk = await WithFileAsync();
        await talk.TypeAsync("SACEPATH", "H", "A1", "", "QSAVE");
        var text = await File.ReadAllTextAsync(talk.PathOf("part.dxf.engraver.json"));
        var used = 0;
        for (var i = 0; i < text.Length; i++)
        {
            foreach (var damaged in (string[])[text[..i], text[..i] + '7' + text[(i + 1)..], text[..i] + '"' + text[(i + 1)..], text[..i] + "-" + text[i..]])
            {
                try
                {
                    SidecarText.Read(damaged);
                    used++;
                }
                catch (Exception told) when (told is JsonException or SidecarVersionException)
                {
                    Assert.NotEmpty(told.Message);
                }
            }
        }

        Assert.InRange(used, 1, 3 * text.Length);
    }

    private static string Shown(DocumentTrajectory one) => FormattableString.Invariant(
        $"{one.Name} {one.MaxErrorMm:R} {one.SegmentLengthMm:R} {string.Join(',', one.Handles)} {one.Curve.Closed} {one.Curve.Z:R} {one.Curve.VerifiedBound:R} {one.Curve.SampledError:R} {one.Curve.SpacingRatio:R} {one.Curve.Length:R} {string.Join(';', one.Curve.Lines)} {string.Join(';', one.Curve.Knots)} {string.Join(';', one.Curve.Heights ?? [])}");

    /// <summary>A session with part.dxf open: a line, an arc, a circle, a square, an ellipse.</summary>
    private static async Task<CommandTestSession> WithFileAsync(string? sidecar = null)
    {
        var talk = new CommandTestSession();
        var file = new DxfText().Header("AC1015", 4).Section(
            "ENTITIES",
            (0, "LINE"), (5, "A1"), (10, 0.0), (20, 0.0), (11, 10.0), (21, 0.0),
            (0, "ARC"), (5, "A2"), (10, 5.0), (20, 5.0), (40, 4.0), (50, 350.0), (51, 100.0),
            (0, "CIRCLE"), (5, "A3"), (10, 20.0), (20, 5.0), (40, 3.0),
            (0, "LWPOLYLINE"), (5, "A4"), (90, 4), (70, 1), (10, 30.0), (20, 0.0), (10, 38.0), (20, 0.0), (10, 38.0), (20, 8.0), (10, 30.0), (20, 8.0),
            (0, "ELLIPSE"), (5, "A5"), (10, 50.0), (20, 5.0), (11, 5.0), (21, 0.0), (40, 0.5), (41, 0.0), (42, 6.283185307179586)).End();
        await File.WriteAllBytesAsync(talk.PathOf("part.dxf"), file.ToAscii());
        if (sidecar is not null) await File.WriteAllTextAsync(talk.PathOf("part.dxf.engraver.json"), sidecar);
        await talk.TypeAsync("OPEN", "part.dxf");
        return talk;
    }
}
