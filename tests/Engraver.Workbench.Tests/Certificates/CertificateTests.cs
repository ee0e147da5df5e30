using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Machines;

namespace Engraver.Workbench.Tests.Certificates;

/// <summary>A certificate is valid only for exactly the verified inputs: a change of one byte of the drawing, a setting, a field of the profile or a character
/// of the program makes it stale, and it names the difference.</summary>
public class CertificateTests
{
    [Fact]
    public async Task What_was_read_back_stands_with_its_figures()
    {
        using var part = new CertifiedPart();
        Assert.Equal(CertificateState.None, part.Standing().State);
        var made = await part.CertifyAsync();

        Assert.Equal(CertificateState.Stands, part.Standing().State);
        Assert.Equal((true, 0.0, 0.0), (made.Ok, made.MissingLength, made.ExtraLength));
        Assert.InRange(made.MaxDeviation!.Value, 0.0, made.Tolerance);
        Assert.Equal(("galil", CertifiedPart.Now, "part.dxf", new FileInfo(part.File).Length), (made.Program.Target, made.Issued, made.Drawing.File, made.Drawing.Bytes));
        Assert.Equal(ContentHash.OfFile(Path.Combine(RepositoryFolder.Samples, "expected", "paper-001.galil.dmc")), made.Program.Sha256);
        var (job, box) = (JobPreparation.Prepare(part.Request().Drawing, part.Settings, MotionStyle.Continuous), made.Limits!);
        var sequence = job.Sequence.Strokes.SelectMany(stroke => stroke.Moves).Aggregate(Bounds2D.Empty, (all, move) => all.Union(move.Segment.Bounds));
        Assert.Equal((sequence.MinX, sequence.MinY, sequence.MaxX, sequence.MaxY, true), (box.MinX, box.MinY, box.MaxX, box.MaxY, box.Fits));
        Assert.Equal(JobPlan.NetworkTimes(job.Motion.Program!).Total, made.PlannedSeconds);
    }

    [Fact]
    public async Task A_changed_byte_of_the_drawing_makes_it_stale_and_the_same_bytes_let_it_stand_again()
    {
        using var part = new CertifiedPart();
        await part.CertifyAsync();
        var bytes = await File.ReadAllBytesAsync(part.File);
        await File.WriteAllBytesAsync(part.File, [.. bytes, (byte)'\n']);
        var changed = part.Standing();
        await File.WriteAllBytesAsync(part.File, bytes);

        Assert.Equal((CertificateState.Stale, "drawing"), (changed.State, Assert.Single(changed.Differences)));
        Assert.Equal(CertificateState.Stands, part.Standing().State);
    }

    [Fact]
    public async Task Another_setting_profile_or_mode_is_named()
    {
        using var part = new CertifiedPart();
        await part.CertifyAsync();
        var other = part.Standing(settings: part.Settings with { JoinToleranceMm = 0.02, Order = Engraver.Core.Sequencing.Ordering.StrokeOrder.Drawn });
        var fed = part.Standing(settings: part.Settings with { Machine = part.Settings.Machine with { FeedMmPerMinute = part.Settings.Machine.FeedMmPerMinute + 1.0 } });

        Assert.Equal((CertificateState.Stale, "join-tolerance order"), (other.State, string.Join(' ', other.Differences)));
        Assert.Equal((CertificateState.Stale, "profile"), (fed.State, string.Join(' ', fed.Differences)));
        Assert.Contains("changed: --join-tolerance, --order;", SettingWording.OnConsole(other.Message), StringComparison.Ordinal);
        Assert.Contains("changed: CNCJOINTOL, CNCORDER;", SettingWording.AtCommandLine(other.Message), StringComparison.Ordinal);
    }

    /// <summary>Each mode sends another program; each has its own certificate file.</summary>
    [Fact]
    public async Task Each_target_has_its_own()
    {
        using var part = new CertifiedPart();
        await part.CertifyAsync();
        var missing = part.Standing(JobMode.Calls);
        await part.CertifyAsync(part.Request("galil-calls"));
        await part.CertifyAsync(part.Request("gcode") with { Dialect = "grbl" });

        Assert.Equal(CertificateState.None, missing.State);
        Assert.Equal([CertificateState.Stands, CertificateState.Stands], new[] { JobMode.Stream, JobMode.Calls }.Select(mode => part.Standing(mode).State));
        Assert.Equal(["part.certificate.json", "part.galil-calls.certificate.json", "part.gcode-grbl.certificate.json"], Directory.GetFiles(Path.GetDirectoryName(part.File)!, "*.json").Select(Path.GetFileName).Order(StringComparer.Ordinal));
        var grbl = CertificateFile.PathOf(part.File, "gcode", "grbl");
        Assert.Equal(CertificateState.Stands, CertificateStatus.Of(grbl, Certification.IdentityOf(part.Request("gcode") with { Dialect = "grbl" })).State);
        Assert.Equal("target", Assert.Single(CertificateStatus.Of(grbl, Certification.IdentityOf(part.Request("gcode"))).Differences));
        File.Copy(CertificateFile.PathOf(part.File, "galil-calls"), part.Certificate, overwrite: true);
        Assert.Equal("target", Assert.Single(part.Standing().Differences));
    }

    /// <summary>2 mm deep, 10 mm above the work between strokes.</summary>
    [Theory]
    [InlineData("galil", 100.0, -2.0, true)]
    [InlineData("gcode", 100.0, -2.0, true)]
    [InlineData("galil", 11.9, -2.0, false)]
    [InlineData("agie", 11.9, null, true)]
    public async Task Where_an_axis_holds_the_tool_the_limits_have_heights(string target, double travel, double? deepest, bool fits)
    {
        var mill = MachineProfile.Default with { Height = new HeightDrive { CutDepth = 2.0, ClearanceHeight = 10.0 } };
        var axes = mill.Axes with { Z = new MachineAxis('C', 1000.0) { Travel = new AxisTravel(-travel, 0.0) } };
        using var part = new CertifiedPart { Settings = new DrawingSettings { Machine = mill with { Axes = axes } } };
        var limits = (await part.CertifyAsync(part.Request(target))).Limits!;

        Assert.Equal((deepest, deepest is null ? null : 10.0, deepest is null ? null : travel, fits), (limits.MinZ, limits.MaxZ, limits.TravelZ, limits.Fits));
        Assert.Equal(limits, CertificateFile.Read(CertificateFile.PathOf(part.File, target)).Certificate!.Limits);
    }

    [Fact]
    public async Task A_letter_of_the_program_that_is_another_makes_it_stale()
    {
        using var part = new CertifiedPart();
        var text = PostedProgram.Create(part.Request().Drawing, part.Settings, PostTable.Find("galil").Post, PostedProgram.NoOptions).Text!;
        var given = await part.CertifyAsync(part.Request() with { Program = ("job.dmc", text) });
        var spoiled = CertificateStatus.Of(part.Certificate, Certification.IdentityOf(part.Request() with { Program = ("job.dmc", text + " ") }));

        Assert.Equal("job.dmc", given.Program.File);
        Assert.Equal(CertificateState.Stands, part.Standing().State);
        Assert.Equal(CertificateState.Stands, CertificateStatus.Of(part.Certificate, Certification.IdentityOf(part.Request() with { Program = ("job.dmc", text) })).State);
        Assert.Equal((CertificateState.Stale, "program"), (spoiled.State, Assert.Single(spoiled.Differences)));
    }

    [Fact]
    public async Task Trajectories_that_run_instead_of_the_drawing_have_none_and_nothing_is_called_changed()
    {
        using var part = new CertifiedPart();
        await part.CertifyAsync();
        var job = JobPreparation.Prepare(part.Request().Drawing, part.Settings, MotionStyle.Continuous);
        var standing = CertificateStatus.OfRun(job with { Trajectories = new FollowedTrajectories(job.Drawing, part.Settings with { MaxErrorMm = 0.002 }, []) }, job.Motion.Program!);

        Assert.Equal(CertificateState.None, standing.State);
        Assert.StartsWith("A certificate covers the drawing only", standing.Check.Message, StringComparison.Ordinal);
        Assert.Equal(CertificateState.Stands, CertificateStatus.OfRun(job, job.Motion.Program!).State);
    }

    /// <summary>A slow serial line reduces the feed: the certificate covers the slower program that is sent.</summary>
    [Fact]
    public async Task The_program_is_the_one_that_the_link_can_carry()
    {
        using var part = new CertifiedPart { Settings = new DrawingSettings { FitArcs = false, Machine = MachineProfile.Default with { FeedMmPerMinute = 6000.0 } } };
        await File.WriteAllBytesAsync(part.File, DxfText.WithEntities([.. Enumerable.Range(0, 800).SelectMany(i => new (int, object)[] { (0, "LINE"), (10, 0.1 * i), (20, 0.0), (11, 0.1 * (i + 1)), (21, 0.0) })]).ToAscii());
        var line = new SerialAddress("/dev/ttyS0", 1200);
        var job = JobPreparation.Prepare(part.Request().Drawing, part.Settings, MotionStyle.Continuous);
        var fit = JobPlan.FitToLink(job.Motion.Program!, line, JobMode.Stream.Strategy(), job.Drawing);
        Assert.NotEmpty(fit.Diagnostics);
        await part.CertifyAsync(part.Request() with { Address = line });

        Assert.Equal(CertificateState.Stands, CertificateStatus.OfRun(job, fit.Program).State);
        Assert.Equal("program", Assert.Single(CertificateStatus.OfRun(job, job.Motion.Program!).Differences));
    }

    [Fact]
    public async Task A_program_of_another_drawing_gets_none()
    {
        using var part = new CertifiedPart();
        var other = await File.ReadAllTextAsync(Path.Combine(RepositoryFolder.Samples, "expected", "gasket.galil.dmc"));
        var made = await Certification.CertifyAsync(part.Request() with { Program = ("gasket.dmc", other) }, null, CancellationToken.None);

        Assert.False(made.Certificate!.Ok);
        Assert.True(made.Certificate.MissingLength > 1.0);
        Assert.Contains(made.Certificate.Findings, found => found is { Severity: "error", Id: "VER0009" });
    }

    [Theory]
    [InlineData("")]
    [InlineData("{")]
    [InlineData("null")]
    [InlineData("[]")]
    [InlineData("{\"version\": 1}")]
    [InlineData("{\"version\": 2, \"drawing\": 7}")]
    public async Task A_file_that_is_no_certificate_is_stale_and_says_why(string text)
    {
        using var part = new CertifiedPart();
        await File.WriteAllTextAsync(part.Certificate, text);
        var standing = part.Standing();

        Assert.Equal((CertificateState.Stale, null), (standing.State, standing.Certificate));
        Assert.NotNull(standing.Problem);
        Assert.EndsWith("[certify] writes a new one", standing.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_certificate_that_says_not_ok_and_one_of_a_later_form_do_not_stand()
    {
        using var part = new CertifiedPart();
        var made = await part.CertifyAsync();
        CertificateFile.Write(part.Certificate, made with { Ok = false });
        Assert.Equal(CertificateState.Stale, part.Standing().State);
        CertificateFile.Write(part.Certificate, made with { Version = 2 });
        Assert.Contains("version 2", part.Standing().Problem, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_list_before_a_start_has_a_line_of_it_that_never_prevents_the_start()
    {
        using var part = new CertifiedPart();
        var (job, ready) = (MachineBench.Job(), new MachineStatus { State = MachineState.Ready, Link = "x", MotorsOn = true });
        ArmingChecklist List(CertificateStatus standing) => ArmingChecklist.Create(job, ready, errorsAccepted: false, MachineBench.Placed, default, standing.Check);
        var none = List(part.Standing());
        await part.CertifyAsync();
        var stands = List(part.Standing());
        var stale = List(part.Standing(settings: part.Settings with { MaxErrorMm = 0.002 }));

        Assert.All([none, stands, stale], list => Assert.True(list.Passed));
        Assert.Equal([("note", false), ("ok", false), ("WARN", true)], new[] { none, stands, stale }.Select(list => (list.Checks[2].Line.Split(' ')[0], list.Checks[2].IsWarning)));
        Assert.Contains("CERTIFY verifies the program", none.Checks[2].Message, StringComparison.Ordinal);
        Assert.StartsWith("The certificate is valid: the program was verified on 2026-11-23", stands.Checks[2].Message, StringComparison.Ordinal);
        Assert.Contains("changed: CNCMAXERR", stale.Checks[2].Message, StringComparison.Ordinal);
    }
}
