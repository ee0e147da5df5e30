using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Setup;
using Engraver.Galil.Setup;
using Engraver.Galil.Tests.Jobs;

namespace Engraver.Galil.Tests.Setup;

/// <summary>Motor types, encoders, switches and error limits: the sent commands, the values read back, and the refusals (galil-dmc.md C).</summary>
public class GalilSetupTests
{
    public static TheoryData<string, SetupValue> Values => new()
    {
        { "_MTA -1", new SetupValue.Motor('A', new MotorType(MotorSignal.Servo, true)) },
        { "_MTA 2", new SetupValue.Motor('A', new MotorType(MotorSignal.LowPulses, false)) },
        { "_MTB 2.5", new SetupValue.Motor('B', new MotorType(MotorSignal.LowPulses, true)) },
        { "_MTA -2", new SetupValue.Motor('A', new MotorType(MotorSignal.HighPulses, false)) },
        { "_MTA -2.5", new SetupValue.Motor('A', new MotorType(MotorSignal.HighPulses, true)) },
        { "_CEA 6", new SetupValue.Encoder('A', new EncoderType(EncoderSignal.Quadrature, true)) }, // the 4 of the auxiliary encoder is kept
        { "_CEB 1", new SetupValue.Encoder('B', new EncoderType(EncoderSignal.PulseAndDirection, false)) },
        { "_ERB 250", new SetupValue.ErrorLimit('B', 250) },
        { "_OEA 3", new SetupValue.OffOnError('A', true) }, // the 2 of the limit switches is kept
        { "_OEA 2", new SetupValue.OffOnError('A', false) },
        { "_CN0 1", new SetupValue.LimitSense(SwitchSense.High) },
        { "_CN1 1", new SetupValue.HomeSense(SwitchSense.High) },
    };

    [Theory]
    [MemberData(nameof(Values))]
    public async Task A_value_is_set_as_the_reference_says_and_read_as_it_was_meant(string wanted, SetupValue value)
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        foreach (var line in (string[])["MOAB", "CEA=4", "OEA=2"]) await session.Commands.SendAsync(line, CancellationToken.None);
        var setup = new GalilSetup(session);

        Assert.Null(await setup.SetAsync(value, CancellationToken.None));

        Assert.Equal(wanted, await HasAsync(bench, wanted.Split(' ')[0]));
        var facts = await setup.ReadAsync("AB", CancellationToken.None);
        Assert.True(value switch
        {
            SetupValue.Motor set => facts[set.Axis].Motor == set.Type,
            SetupValue.Encoder set => facts[set.Axis].Encoder == set.Type,
            SetupValue.ErrorLimit set => facts[set.Axis].ErrorLimit == set.Counts,
            SetupValue.OffOnError set => facts[set.Axis].OffOnError == set.IsOn,
            SetupValue.LimitSense set => facts.LimitSense == set.Sense && facts.HomeSense == SwitchSense.Low,
            SetupValue.HomeSense set => facts.HomeSense == set.Sense && facts.LimitSense == SwitchSense.Low,
            _ => false,
        });
    }

    [Fact]
    public async Task Motor_type_and_encoder_of_a_motor_that_is_on_are_left_alone()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        var setup = new GalilSetup(session);

        Assert.Contains("motor of axis A is on", await setup.SetAsync(new SetupValue.Motor('A', new MotorType(MotorSignal.LowPulses, false)), CancellationToken.None), StringComparison.Ordinal);
        Assert.Contains("motor of axis A is on", await setup.SetAsync(new SetupValue.Encoder('A', new EncoderType(EncoderSignal.Quadrature, true)), CancellationToken.None), StringComparison.Ordinal);

        Assert.Equal(("_MTA 1", "_CEA 0"), (await HasAsync(bench, "_MTA"), await HasAsync(bench, "_CEA")));
    }

    [Fact]
    public async Task A_refusal_is_a_sentence_with_the_controllers_own_words_and_changes_nothing()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();

        var why = await new GalilSetup(session).SetAsync(new SetupValue.ErrorLimit('A', -7), CancellationToken.None);

        Assert.Contains("ERA=-7", why, StringComparison.Ordinal);
        Assert.Equal("_ERA 16384", await HasAsync(bench, "_ERA"));
    }

    [Theory]
    [InlineData("MTA=-1")]
    [InlineData("CEA=2")]
    public async Task A_servo_whose_loop_has_the_wrong_sign_is_off_again_within_its_error_limit(string wrong)
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        foreach (var line in (string[])["MOA", wrong, "ERA=300"]) await session.Commands.SendAsync(line, CancellationToken.None);

        var why = await new GalilSetup(session).SwitchMotorAsync('A', on: true, CancellationToken.None);

        Assert.Contains("ran away", why, StringComparison.Ordinal);
        Assert.Equal("_MOA 1", await HasAsync(bench, "_MOA"));
        Assert.InRange(Math.Abs(int.Parse(await bench.WholeAsync("_TPA"), CultureInfo.InvariantCulture)), 300, 3000);
    }

    [Fact]
    public async Task A_motor_that_stays_where_it_is_stays_on()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        var setup = new GalilSetup(session);
        Assert.Null(await setup.SwitchMotorAsync('B', on: false, CancellationToken.None));
        Assert.True((await setup.ReadAsync("B", CancellationToken.None))['B'].IsMotorOff);

        Assert.Null(await setup.SwitchMotorAsync('B', on: true, CancellationToken.None));

        Assert.Equal("_MOB 0", await HasAsync(bench, "_MOB"));
    }

    [Fact]
    public async Task What_is_burned_is_there_after_a_reset_and_the_conversation_of_the_session_is_not_burned_with_it()
    {
        await using var bench = new SimulatedBench();
        var found = await HasAsync(bench, "_CW");
        await using (var session = await bench.OpenAsync())
        {
            var setup = new GalilSetup(session);
            Assert.Null(await setup.SetAsync(new SetupValue.ErrorLimit('A', 777), CancellationToken.None));
            Assert.Null(await setup.BurnAsync(CancellationToken.None));
            Assert.Equal("_CW 1", await HasAsync(bench, "_CW")); // the session continues with its settings
        }

        await bench.SendAsync("ERA=5", "CW 1", "RS");

        Assert.Equal(("_ERA 777", found), (await HasAsync(bench, "_ERA"), await HasAsync(bench, "_CW")));
    }

    [Fact]
    public async Task An_output_that_is_tried_goes_off_by_itself_when_this_computer_is_no_more()
    {
        await using var bench = new SimulatedBench();

        var result = await PulseAsync(bench, bench.Controller.DropConnections);
        bench.ReleaseClock();
        bench.Controller.Advance(TimeSpan.FromSeconds(3));

        Assert.Equal(JobOutcome.LinkLost, result.Outcome);
        Assert.InRange(SamplesOn(bench), 1, 1500); // the watchdog of EX12
    }

    [Fact]
    public async Task An_output_that_is_tried_goes_off_at_the_operators_stop()
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();

        var result = await PulseAsync(bench, stop.Cancel, stop.Token);

        Assert.Equal(JobOutcome.Stopped, result.Outcome);
        Assert.InRange(SamplesOn(bench), 1, 300); // of 512
    }

    [Fact]
    public async Task No_output_is_tried_while_a_motor_is_off_and_the_motor_stays_off()
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("MOA");

        Assert.Equal(JobOutcome.Refused, (await PulseAsync(bench, () => { })).Outcome);

        Assert.DoesNotContain(bench.Controller.Record.Snapshot(), row => row.Outputs != 0);
        Assert.Equal("_MOA 1", await HasAsync(bench, "_MOA"));
    }

    /// <summary>Tries output 3 for half a second.</summary>
    /// <param name="meanwhile">Called once, after 20 lines were sent with the output on.</param>
    private static async Task<JobResult> PulseAsync(SimulatedBench bench, Action meanwhile, CancellationToken stop = default)
    {
        var lines = -1;
        await using var session = await bench.OpenAsync(link => link.Sending = line =>
        {
            if (line.StartsWith("SB 3", StringComparison.Ordinal)) lines = 0;
            if (lines >= 0 && ++lines == 20) meanwhile();
        });
        var test = MachineProfile.Default with { ToolOutput = 3, ToolSettleSeconds = 0.5 };
        return await new GalilSetup(session).PulseAsync(new MotionProgram(test, default, []), new JobOptions(), stop);
    }

    /// <summary>Number of samples for which output 3 was on; it is off at the end.</summary>
    private static long SamplesOn(SimulatedBench bench)
    {
        var rows = bench.Controller.Record.Snapshot();
        var on = rows.First(row => (row.Outputs & 4) != 0).Sample;
        Assert.Equal(0, rows[^1].Outputs);
        return rows.First(row => row.Sample > on && row.Outputs == 0).Sample - on;
    }

    /// <summary>Compares an operand with the value read by another host.</summary>
    private static async Task<string> HasAsync(SimulatedBench bench, string operand) => $"{operand} {await bench.NumberAsync(operand)}";
}
