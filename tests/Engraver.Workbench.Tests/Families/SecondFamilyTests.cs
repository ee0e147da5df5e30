using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Families;

/// <summary>A controller family is its driver and an entry in <see cref="MachineFamilies"/>: the profile selects it, it has its own form of address, its own
/// strategies and its own axis letters, and jobs are prepared, run and recorded with it.</summary>
public sealed class SecondFamilyTests : IAsyncDisposable
{
    private const string Profile = """{ "controller": "tiny", "axisX": "X", "axisY": "Y", "countsPerMillimetreX": 100, "countsPerMillimetreY": 100 }""";

    private readonly TinyPlotter _plotter = new();
    private readonly CommandTestSession _talk;

    public SecondFamilyTests()
    {
        _talk = new CommandTestSession(new MachineFamilies([.. MachineFamilies.Standard.All, Tiny(_plotter)]));
        File.WriteAllText(_talk.PathOf("tiny.json"), Profile);
        File.WriteAllText(_talk.PathOf("angle.dxf"), "0\nSECTION\n2\nENTITIES\n" + Line(1, 1, 4, 1) + Line(4, 1, 4, 3) + "0\nENDSEC\n0\nEOF\n");
    }

    public ValueTask DisposeAsync() => _talk.DisposeAsync();

    [Theory]
    [InlineData("Plot", "plot", "DOWN|GO 400 100|GO 400 300|UP")]
    [InlineData("dAsh", "dash", "DOWN|GO 400 100|UP|DOWN|GO 400 300|UP")]
    public async Task A_job_is_prepared_run_and_recorded_by_the_driver_that_the_profile_names(string keyword, string key, string path)
    {
        await _talk.TypeAsync("OPEN", "angle.dxf", "CNCPROFILE", "tiny.json", "CNCCONNECT", "tiny://bench", "CNCZERO", "All");
        await _talk.TypeAsync("CNCARM", keyword, "CNCRUN");
        var entry = Assert.Single(_talk.Session.History.Refresh().Entries);

        Assert.Contains("Connected to TINY-1", _talk.Said, StringComparison.Ordinal);
        Assert.Contains($"mode {keyword}", _talk.Said, StringComparison.Ordinal);
        Assert.Equal(("run", "complete", key, "tiny", "tiny://bench"), (entry.Kind, entry.Outcome, entry.Mode, entry.Target, entry.Address));
        Assert.Contains(path, string.Join('|', _plotter.Done), StringComparison.Ordinal);
        Assert.InRange(entry.MaxDeviation!.Value, 0.0, 0.01);
    }

    [Fact]
    public async Task The_run_of_the_history_is_opened_with_its_controller_again()
    {
        await _talk.TypeAsync("OPEN", "angle.dxf", "CNCPROFILE", "tiny.json", "CNCCONNECT", "tiny://bench", "CNCZERO", "All", "CNCARM", "Plot", "CNCRUN");
        var entry = Assert.Single(_talk.Session.History.Refresh().Entries);

        Assert.IsType<TinyDriver>(entry.ToSettings(_talk.Session.Families).Machine.Controller);
        Assert.Throws<FormatException>(() => entry.ToSettings(MachineFamilies.Standard));
    }

    [Fact]
    public async Task The_plan_is_the_drivers_and_a_family_without_a_post_has_no_program_text()
    {
        await _talk.TypeAsync("OPEN", "angle.dxf", "CNCPROFILE", "tiny.json");
        var derived = await _talk.Session.Derivation.ForCurrentAsync(CancellationToken.None);

        Assert.Equal(TinyDriver.Plot, derived.Strategy);
        Assert.Equal(2, derived.Job!.Motion.Program!.SegmentCount);
        Assert.True(derived.Plan!.Value.Total > 0.0);
        Assert.Null(derived.Program);
    }

    [Fact]
    public async Task A_strategy_of_another_driver_is_not_offered()
    {
        await _talk.TypeAsync("OPEN", "angle.dxf", "CNCPROFILE", "tiny.json", "CNCCONNECT", "tiny://bench", "CNCZERO", "All", "CNCARM", "Stream");

        Assert.Null(_talk.Session.Machine.Arming.Armed);
        Assert.Contains("[Plot/dAsh/", _talk.Session.Prompt!.Text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("tiny.json", "sim:", "Tiny plotter", "sim:")]
    [InlineData(null, "tiny://bench", "Galil DMC-21x3", "tiny://bench")]
    public async Task An_address_of_another_family_than_that_of_the_profile_is_refused(string? profile, string address, string controller, string reached)
    {
        if (profile is not null) await _talk.TypeAsync("OPEN", "angle.dxf", "CNCPROFILE", profile);
        var failed = Assert.IsType<InputResult.Failed>(await _talk.TypeAsync("CNCCONNECT", address));

        Assert.Contains($"The machine profile names a {controller} controller, which is not reached at {reached}.", failed.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_profile_that_names_an_unknown_controller_is_refused_with_its_line()
    {
        var read = MachineFamilies.Standard.ReadProfile("{\n \"controller\": \"tiny\" }");

        Assert.Null(read.Profile);
        Assert.Contains("controller to tiny; required: one of galil", Assert.Single(read.Diagnostics).Message, StringComparison.Ordinal);
        Assert.Equal(2, read.Diagnostics[0].Source.Line);
    }

    [Fact]
    public void A_profile_that_names_no_controller_has_the_default_driver()
    {
        Assert.Equal("galil", MachineFamilies.DriverOf(MachineProfile.Default).Key);
        Assert.Same(MachineFamilies.Default, MachineFamilies.DriverOf(MachineFamilies.Standard.ReadProfile("""{ "controller": "galil" }""").Profile!));
        Assert.Equal(["stream", "calls", "program"], MachineFamilies.Default.Strategies.Select(strategy => strategy.Key));
    }

    [Fact]
    public void A_driver_refuses_a_strategy_of_another_one() => Assert.Throws<ArgumentException>(() => JobModes.Of(TinyDriver.Plot));

    private static MachineFamily Tiny(TinyPlotter plotter)
    {
        var driver = new TinyDriver();
        return new MachineFamily
        {
            Driver = driver,
            Accepts = address => address is TinyAddress,
            ParseAddress = text => text.StartsWith("tiny://", StringComparison.Ordinal) ? new TinyAddress(text[7..]) : null,
            AddressForms = ["tiny://NAME"],
            Connect = (address, time, _, _) => MachineConnection.FromLink(address.Typed, _ => Task.FromResult(plotter.Open()), () => MachineClock.FromWall(time), driver),
        };
    }

    private static string Line(int x1, int y1, int x2, int y2) => $"0\nLINE\n8\n0\n10\n{x1}\n20\n{y1}\n11\n{x2}\n21\n{y2}\n";

    private sealed record TinyAddress(string Name) : ControllerAddress
    {
        public override string Typed => "tiny://" + Name;
    }
}
