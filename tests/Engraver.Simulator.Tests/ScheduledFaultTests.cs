using System.Text.Json;

namespace Engraver.Simulator.Tests;

/// <summary>Faults at a time of the controller's clock, at a segment, or at a byte received.</summary>
public sealed class ScheduledFaultTests
{
    [Fact]
    public async Task A_limit_switch_is_hit_at_its_time_and_free_again_after_its_duration()
    {
        await using var rig = WithFaults("""{"kind":"limitSwitch","axis":"A","forward":true,"atSeconds":0.5,"forSeconds":0.25}""");
        rig.Do("SPA=1000", "PRA=5000", "BGA");

        rig.Controller.Advance(TimeSpan.FromSeconds(0.6));
        Assert.Equal((0, 2), (rig.Value("_LFA"), rig.Value("_SCA"))); // hit; stopped by the forward limit switch
        var braked = rig.Controller.Record.Snapshot()[^1];
        Assert.InRange(braked.A, 480, 505); // half a second at 1000 counts/s, and the braking path
        rig.Controller.Advance(TimeSpan.FromSeconds(0.25));
        Assert.Equal(1, rig.Value("_LFA"));
    }

    [Fact]
    public async Task A_segment_is_a_moment_too()
    {
        await using var rig = WithFaults("""{"kind":"motorOff","axis":"B","atSegment":2}""");
        rig.Do("VM AB", "VS 2000", "VP 1000,0", "VP 1000,1000", "VP 0,1000", "VP 0,0", "VE", "BGS");

        rig.RunToIdle();
        var last = rig.Controller.Record.Snapshot()[^1];
        Assert.Equal(1000, last.B);
        Assert.InRange(last.A, 900, 1000); // at the corner after the second segment, without a ramp
        Assert.Equal((1, 8), (rig.Value("_MOB"), rig.Value("_SCB")));
    }

    [Fact]
    public async Task A_lost_command_does_nothing_and_a_lost_answer_is_a_command_that_was_done()
    {
        await using var command = WithFaults("""{"kind":"dropCommand","atByte":5}""");
        Assert.Equal([":", "", ":"], [command.Ask("x=1"), command.Ask("x=2"), command.Ask("")]);
        Assert.Equal(1, command.Value("x"));

        await using var reply = WithFaults("""{"kind":"dropReply","atByte":5,"count":2}""");
        Assert.Equal([":", "", "", ":"], [reply.Ask("x=1"), reply.Ask("x=2"), reply.Ask("x=x+5"), reply.Ask("")]);
        Assert.Equal(7, reply.Value("x"));
    }

    [Fact]
    public async Task Garbage_comes_before_one_answer()
    {
        await using var rig = WithFaults("""{"kind":"garbage","atByte":1,"count":7}""");
        var answer = rig.Ask("x=1");

        Assert.Equal((8, ':'), (answer.Length, answer[^1]));
        Assert.Equal(":", rig.Ask("x=2"));
    }

    [Fact]
    public async Task A_late_answer_takes_its_time_of_the_controller_and_at_a_given_speed_of_the_wall()
    {
        await using var rig = WithFaults("""{"kind":"delay","atByte":1,"seconds":0.3}""");
        var before = rig.Controller.Status.Sample;
        Assert.Equal(":", rig.Ask("x=1"));
        Assert.InRange(rig.Controller.Status.Sample - before, 300, 303);

        var time = new StoppedTimeProvider();
        await using var paced = new SimulatedController(new SimulatorOptions { Time = time, Faults = Plan("""{"kind":"delay","atByte":1,"seconds":0.3}""") });
        await using var stream = paced.OpenConnection();
        Assert.Equal("", SimulatorRig.Exchange(stream, "x=1\rx=2\r"));
        time.Advance(TimeSpan.FromSeconds(0.29));
        Assert.Equal("", SimulatorRig.ReadAvailable(stream));
        time.Advance(TimeSpan.FromSeconds(0.02));
        Assert.Equal("::", SimulatorRig.ReadAvailable(stream)); // the order is kept
    }

    [Fact]
    public async Task A_reset_cuts_every_link_and_motion_goes_on()
    {
        await using var rig = WithFaults("""{"kind":"reset","atSeconds":0.5}""");
        rig.Do("SPA=1000", "PRA=5000", "BGA");
        rig.RunToIdle();

        Assert.Throws<IOException>(() => rig.Ask(""));
        Assert.Equal(5000, rig.Controller.Record.Snapshot()[^1].A);
    }

    [Fact]
    public async Task The_abort_input_halts_at_once_and_a_jam_lets_the_error_grow()
    {
        await using var abort = WithFaults("""{"kind":"abortInput","atSeconds":0.5,"forSeconds":1}""");
        abort.Do("SPA=1000", "PRA=5000", "BGA");
        abort.Controller.Advance(TimeSpan.FromSeconds(1));
        Assert.Equal((0, 6), (abort.Value("_AB"), abort.Value("_SCA")));
        abort.Controller.Advance(TimeSpan.FromSeconds(1));
        Assert.Equal(1, abort.Value("_AB"));

        await using var jam = WithFaults("""{"kind":"jam","axis":"A","atSeconds":0.5}""");
        jam.Do("SPA=1000", "PRA=5000", "BGA");
        jam.Controller.Advance(TimeSpan.FromSeconds(1));
        Assert.InRange(jam.Value("_TEA"), 400, 600);
    }

    [Fact]
    public async Task A_power_cycle_loses_links_variables_programs_and_positions_and_starts_the_clock_anew()
    {
        await using var rig = WithFaults("""{"kind":"powerCycle","atSeconds":2}""");
        rig.Do("mark=77", "SB 1", "PRA=500", "BGA");
        rig.Controller.Advance(TimeSpan.FromSeconds(3));

        Assert.Throws<IOException>(() => rig.Ask(""));
        await using var again = rig.Controller.OpenConnection();
        Assert.Equal(" 0.0000 0.0000\r\n:", SimulatorRig.Exchange(again, "MG _RPA,_OP0\r"));
        Assert.Equal("?", SimulatorRig.Exchange(again, "MG mark\r"));
        Assert.InRange(double.Parse(SimulatorRig.Exchange(again, "MG TIME\r")[..^3], System.Globalization.CultureInfo.InvariantCulture), 900, 1100);
    }

    [Fact]
    public async Task A_fault_is_scheduled_while_the_controller_runs_and_one_whose_moment_is_past_happens_at_once()
    {
        await using var rig = new SimulatorRig();
        rig.Do("SPA=1000", "PRA=5000", "BGA");
        rig.Controller.Advance(TimeSpan.FromSeconds(1));
        rig.Controller.Schedule(new ScheduledFault { Kind = FaultKind.LimitSwitch, Axis = "A", Forward = true, AtSeconds = 0.2 });
        rig.RunToIdle();
        Assert.InRange(rig.Controller.Record.Snapshot()[^1].A, 980, 1010);

        rig.Controller.Schedule(new ScheduledFault { Kind = FaultKind.DropCommand, AtByte = rig.Controller.BytesArrived + 5 });
        Assert.Equal([":", ""], [rig.Ask("x=1"), rig.Ask("x=2")]);
        Assert.Throws<ArgumentException>(() => rig.Controller.Schedule(new ScheduledFault { Kind = FaultKind.Jam, AtByte = 1 }));
    }

    /// <summary>The counted position changes, and the machine does not move.</summary>
    [Fact]
    public async Task The_real_place_of_a_motor_and_of_a_position_outlives_DP_and_a_power_cycle()
    {
        await using var rig = new SimulatorRig();
        rig.Do("PRA=5000", "BGA");
        rig.RunToIdle();
        Assert.Equal((5000, 5000, 0), (rig.Controller.MotorPlace(0), rig.Controller.PlaceOf(0, 5000), rig.Controller.MotorPlace(1)));

        rig.Do("DPA=-70");
        Assert.Equal((5000, 5070), (rig.Controller.MotorPlace(0), rig.Controller.PlaceOf(0, 0)));

        rig.Controller.HoldMotor(0, true);
        rig.Do("PRA=300", "BGA");
        rig.RunToIdle();
        rig.Controller.Schedule(new ScheduledFault { Kind = FaultKind.PowerCycle, AtByte = 0 });
        rig.Controller.Advance(TimeSpan.FromMilliseconds(5));
        Assert.Equal((5000, 5000), (rig.Controller.MotorPlace(0), rig.Controller.PlaceOf(0, 0))); // the motor that could not follow has not moved, and its position is defined as 0
    }

    [Fact]
    public async Task Without_scheduled_faults_steady_motion_is_the_same_as_with_one_that_never_comes()
    {
        await using var plain = new SimulatorRig();
        await using var waiting = WithFaults("""{"kind":"reset","atSegment":1000000}""");
        foreach (var rig in new[] { plain, waiting })
        {
            rig.Do("VM AB", "VP 30000,10000", "CR 5000,0,180", "VE", "BGS");
            rig.RunToIdle();
        }

        Assert.Equal(plain.Controller.Record.Snapshot(), waiting.Controller.Record.Snapshot());
    }

    [Theory]
    [InlineData("""{"kind":"reset"}""", "kind", FaultErrorReason.Moments)]
    [InlineData("""{"kind":"reset","atSeconds":1,"atByte":2}""", "kind", FaultErrorReason.Moments)]
    [InlineData("""{"kind":"jam","atSeconds":1}""", "kind", FaultErrorReason.NoAxis)]
    [InlineData("""{"kind":"reset","atSeconds":1,"axis":"A"}""", "axis", FaultErrorReason.HasNoAxis)]
    [InlineData("""{"kind":"jam","atSeconds":1,"axis":"E"}""", "axis", FaultErrorReason.OtherAxis)]
    [InlineData("""{"kind":"reset","atSeconds":1,"forSeconds":1}""", "forSeconds", FaultErrorReason.NeverEnds)]
    [InlineData("""{"kind":"jam","atSeconds":1,"axis":"A","forSeconds":0}""", "forSeconds", FaultErrorReason.NotAboveZero)]
    [InlineData("""{"kind":"garbage","atByte":-1}""", "atByte", FaultErrorReason.BelowZero)]
    [InlineData("""{"kind":"garbage","atSeconds":-1}""", "atSeconds", FaultErrorReason.BelowZero)]
    [InlineData("""{"kind":"garbage","atSegment":-1}""", "atSegment", FaultErrorReason.BelowZero)]
    [InlineData("""{"kind":"delay","atByte":1,"seconds":-1}""", "seconds", FaultErrorReason.BelowZero)]
    [InlineData("""{"kind":"garbage","atByte":1,"count":0}""", "count", FaultErrorReason.BelowOne)]
    public void A_fault_that_makes_no_sense_is_refused_with_a_reason(string fault, string field, FaultErrorReason reason)
    {
        var refused = Assert.Throws<FaultPlanException>(() => FaultPlan.Parse($$"""{"faults":[{"kind":"reset","atByte":9},{{fault}}]}"""));

        Assert.Equal((1, new FaultError(field, reason)), (refused.Fault, refused.Error));
    }

    [Fact]
    public void A_kind_of_fault_that_does_not_exist_is_refused() => Assert.Throws<JsonException>(() => Plan("""{"kind":"flood","atByte":1}"""));

    private static SimulatorRig WithFaults(string fault) => new(new SimulatorOptions { Faults = Plan(fault) });

    private static FaultPlan Plan(string fault) => FaultPlan.Parse($$"""{"faults":[{{fault}}]}""");
}
