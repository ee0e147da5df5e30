using Engraver.Simulator.Language;
using Engraver.Simulator.Motion;
using Engraver.Simulator.Protocol;
using Engraver.Simulator.Values;

namespace Engraver.Simulator;

/// <summary>The controller without wall time: it takes commands and advances by samples. The owner ensures that calls never overlap.</summary>
internal sealed class Machine
{
    private static readonly long TicksPerSample = TimeSpan.TicksPerMillisecond;

    private long _clockTicks;
    private readonly MotionRecorder _recorder;
    private int _sampleMicroseconds = 1000;
    private long _timeBefore;
    private long _timeSince;

    public Machine(SimulatorOptions options)
    {
        Options = options;
        Motion = new MotionKernel(options);
        _recorder = new MotionRecorder(Motion, Io, options.KeepsRecord);
        Inputs = new InputChanges(this);
        Records = new DataRecordPush(this);
        Capture = new ArrayCapture(this);
        Program = new ProgramMemory(options.ProgramLines);
        Handles = new HandleTable(options.HandleCount);
        Threads = new Scheduler(this);
        Interpreter = new Interpreter(this);
        Messages = new MessageRouter(Handles, Serial, options);
        Burned = new BurnedState(this);
        Faults = new FaultSchedule(this, options.Faults);
    }

    public SimulatorOptions Options { get; }

    public MotionKernel Motion { get; }

    public DigitalIo Io { get; } = new();

    public VariableStore Variables { get; } = new();

    public ProgramMemory Program { get; }

    public HandleTable Handles { get; }

    public SerialPort Serial { get; } = new();

    public Scheduler Threads { get; }

    public Interpreter Interpreter { get; }

    public MessageRouter Messages { get; }

    public MotionRecord Record => _recorder.Record;

    /// <summary>The injected faults and their triggers.</summary>
    public FaultSchedule Faults { get; }

    /// <summary>Changes from outside: input lines and characters on the serial port.</summary>
    public InputChanges Inputs { get; }

    /// <summary>Controller time since power up, ticks of 100 ns; samples are whole milliseconds of it.</summary>
    public long ClockTicks => _clockTicks;

    /// <summary>Samples of 1 ms nominal since power up.</summary>
    public long Sample { get; private set; }

    /// <summary>The code that TC reports and clears.</summary>
    public int LastError { get; set; }

    public NumberFormat PositionFormat { get; set; } = NumberFormat.Position;

    public NumberFormat VariableFormat { get; set; } = NumberFormat.Variable;

    /// <summary>LZ: leading zeros are stripped.</summary>
    public bool StripLeadingZeros { get; set; } = true;

    /// <summary>VF and LZ together: how values print.</summary>
    public NumberFormat ValueFormat => Padded(VariableFormat);

    /// <summary>TM: the nominal sample in microseconds.</summary>
    public int SampleMicroseconds
    {
        get => _sampleMicroseconds;
        set
        {
            _timeBefore = Time;
            _timeSince = Sample;
            _sampleMicroseconds = value;
            Motion.Contour.SamplesPerStep = SamplesPerMillisecond;
        }
    }

    /// <summary>1000/TM.</summary>
    public double SamplesPerMillisecond => 1000.0 / _sampleMicroseconds;

    /// <summary>TIME: samples of TM since power up.</summary>
    public long Time => _timeBefore + (long)((Sample - _timeSince) * SamplesPerMillisecond);

    public InputInterrupt InputInterrupt { get; } = new();

    /// <summary>CI and #COMINT.</summary>
    public SerialInterrupt SerialInterrupt { get; } = new();

    public DataRecordPush Records { get; }

    /// <summary>RA, RD, RC.</summary>
    public ArrayCapture Capture { get; }

    /// <summary>TB (galil-dmc.md A.10).</summary>
    public int StatusByte =>
        (Threads.AnyRunning ? 0x80 : 0)
        | (Motion.Contour.IsOn ? 0x20 : 0)
        | (Threads[0].Calls.Any(static c => c.Interrupt) && !InputInterrupt.IsRunning ? 0x10 : 0)
        | (InputInterrupt.IsArmed ? 0x08 : 0)
        | (InputInterrupt.IsRunning ? 0x04 : 0)
        | (Serial.Echo ? 0x01 : 0);

    /// <summary>The state saved by BN and BV.</summary>
    public BurnedState Burned { get; }

    /// <summary>The program that BP saved; RS restores it.</summary>
    public string[] BurnedProgram { get; set; } = [];

    /// <summary>Counter that changes with every event that a silent host could be waiting for.</summary>
    public long Events => Motion.Ends + Threads.Events + Records.Sent + Capture.Ends + _outputChanges;

    private long _outputChanges;

    /// <summary>A sequence has been started and not closed, so that its host must still send segments; at speed max, time then stops (contract of
    /// <c>simulate</c>).</summary>
    public bool AwaitsSegments => Motion.Planes.Any(p => p.IsActive && !p.Buffer.IsClosed && !p.Profile.IsStopping) || Motion.Contour.AwaitsRecords;

    /// <summary>Nothing moves and no thread runs: only a command or an input can change the state.</summary>
    public bool IsDormant => !Motion.CanProgress && !Threads.AnyRunning && !Records.IsOn && !Capture.IsOn && Faults.NextDue == long.MaxValue;

    /// <summary>The first sample in which an event can occur without a command or an input, while nothing moves; long.MaxValue when no event can
    /// occur.</summary>
    public long QuietUntil => Math.Min(Threads.QuietUntil(Sample), NextSnapshot);

    /// <summary>The sample in which the next data record, captured value or fault is due.</summary>
    private long NextSnapshot => Math.Min(Math.Min(Records.NextDue, Capture.NextDue), Math.Max(Faults.NextDue, Sample + 1));

    /// <summary>The variable axes ~a to ~h.</summary>
    public VariableAxes VariableAxes { get; } = new();

    public string Print(FixedPoint value) => ValueFormat.Print(value);

    /// <summary>PF and LZ together: how positions print.</summary>
    public string PrintPosition(int value) => Padded(PositionFormat).Print(FixedPoint.FromInteger(value));

    /// <summary>Formats the answer to a query whose whole number PF does not format.</summary>
    public string PrintWhole(long value) => Padded(NumberFormat.Position).Print(FixedPoint.FromInteger(value));

    /// <summary>Applies leading zeros under LZ 0, which holds for the answer to every query (A.3).</summary>
    public NumberFormat Padded(NumberFormat format) => format with { LeadingZeros = !StripLeadingZeros };

    /// <summary>Advances controller time.</summary>
    public void Advance(TimeSpan time)
    {
        _clockTicks += time.Ticks;
        while (_clockTicks >= (Sample + 1) * TicksPerSample)
        {
            PassTowards(_clockTicks / TicksPerSample);
        }
    }

    /// <summary>Advances time to the next event, or by <paramref name="atMost"/> samples when there is no event.</summary>
    public void AdvanceToEvent(long atMost)
    {
        var events = Events;
        var limit = Sample + atMost;
        while (Events == events && Sample < limit && !IsDormant) PassTowards(limit);

        _clockTicks = Math.Max(_clockTicks, Sample * TicksPerSample);
    }

    /// <summary>Advances time until nothing moves and no thread runs, for at most <paramref name="atMost"/> samples, <paramref name="longestRest"/> samples
    /// without motion or a change of an output, and <paramref name="steps"/> steps of computing.</summary>
    /// <returns>True when the rest lasted <paramref name="longestRest"/>, or will last until a command arrives.</returns>
    public bool AdvanceToRest(long atMost, long longestRest, int steps)
    {
        var limit = Sample + atMost;
        for (var start = Sample; !IsDormant && Sample < limit && steps > 0; steps--)
        {
            var rested = Math.Max(start, _recorder.LastSample) + longestRest;
            if (Sample >= rested) return true;
            PassTowards(_recorder.IsMoving ? limit : Math.Min(limit, rested));
            _clockTicks = Math.Max(_clockTicks, Sample * TicksPerSample);
        }

        return IsDormant;
    }

    public void SetOutputs(byte value)
    {
        if (value == Io.Outputs) return;

        Io.SetOutputs(value);
        _outputChanges++;
        _recorder.OutputsChanged(Sample);
    }

    /// <summary>AB: stops without ramps; motors with OE 1 or 3 are switched off (B.8).</summary>
    public void Abort(bool programsToo, int stopCode)
    {
        foreach (var plane in Motion.Planes) plane.Halt(stopCode);
        Motion.Contour.End(stopCode);
        Motion.Cam.Disable(stopCode);

        foreach (var axis in Motion.Axes)
        {
            axis.Halt(stopCode);
            axis.Gear.Release();
            axis.MotorOff |= axis.OffOnError is 1 or 3;
        }

        if (programsToo) Threads.HaltAll();
    }

    /// <summary>True when the abort input is closed (<c>_AB</c> 0).</summary>
    public bool IsAbortInputActive { get; private set; }

    /// <summary>The change to active triggers the abort. Motion that starts while the input stays active is not blocked.</summary>
    public void SetAbortInput(bool active)
    {
        var edge = active && !IsAbortInputActive;
        IsAbortInputActive = active;
        if (edge) Abort(!Motion.Polarity.AbortKeepsPrograms, StopCode.AbortInput);
    }

    /// <summary>RS: restores the burned state (A.1); #AUTO starts if the burned program contains it.</summary>
    public void Reset()
    {
        Abort(true, StopCode.Aborted);
        Variables.Clear();
        Program.Truncate(0);
        foreach (var line in BurnedProgram) Program.Append(line);

        Messages.Reset();
        SerialInterrupt.Configure(0, takesData: false);
        InputInterrupt.Arm(0, 0);
        LastError = 0;
        Motion.Cam.Reset();
        Capture.Stop();
        Motion.Contour.TimeExponent = 0;
        Motion.Selected = Motion.Planes[0];
        foreach (var axis in Motion.Axes) axis.Redefine(0);
        Burned.Restore();

        if (Program.TryFind("AUTO", out var line0)) Threads[0].Start(line0, Sample);
    }

    /// <summary>Cuts every link at once, as a pulled cable would.</summary>
    public void CutLinks()
    {
        foreach (var handle in Handles.Open.ToArray()) handle.Cut();

        Serial.Client?.Cut();
    }

    /// <summary>Power cycle: as RS, and the links and the clock of the controller restart. The motors keep their physical positions, which become position
    /// 0.</summary>
    public void PowerCycle()
    {
        CutLinks();
        Reset();
        _timeBefore = 0;
        _timeSince = Sample;
    }

    /// <summary>Computes one sample, or a jump over samples in which no event can occur.</summary>
    private void PassTowards(long lastSample)
    {
        if (!Motion.CanProgress && Threads.QuietUntil(Sample) is var quiet && quiet > Sample + 1)
        {
            Sample = Math.Min(Math.Min(quiet - 1, lastSample), NextSnapshot);
            Records.Step();
            Capture.Step();
            Threads.ForgetUnusedTime();
            _recorder.Rested();
            Faults.Step();
            return;
        }

        if (Options.JumpsSteadyMotion && !Faults.AwaitsSegment && _recorder.IsMoving && TryJump(lastSample)) return;
        Sample++;
        StepMotion();
        Threads.RunSample();
        Records.Step();
        Capture.Step();
        Faults.Step();
    }

    /// <summary>Skips samples of constant speed in which no thread runs, nothing is recorded and no limit is reached; the sample after them is computed
    /// normally.</summary>
    private bool TryJump(long lastSample)
    {
        var samples = Motion.Steady.Samples(Math.Min(lastSample, NextSnapshot) - Sample - 1);
        if (samples == 0) return false;
        samples = Math.Min(samples, Threads.QuietWhileSteady(Sample) - Sample - 1);
        if (samples < SteadyMotion.Shortest) return false;
        var courses = Motion.Steady.Courses();
        samples = SamplesWithoutEvent(samples);
        Motion.Steady.Pass(samples);
        if (samples == 0) return false;
        _recorder.Passed(Sample, samples, courses);
        Sample += samples;
        Threads.Pass(samples);
        return true;
    }

    /// <summary>Bisects for the largest number of samples after which no thread is released and no limit is reached. No axis changes direction within them, so
    /// that an event which has not occurred after the last sample has not occurred earlier.</summary>
    private long SamplesWithoutEvent(long samples)
    {
        if (!HappensWithin(samples)) return samples;
        var (without, with) = (0L, samples);
        while (with - without > 1)
        {
            var middle = without + ((with - without) / 2);
            if (HappensWithin(middle)) with = middle;
            else without = middle;
        }

        return without;
    }

    private bool HappensWithin(long samples)
    {
        Motion.Steady.Place(samples);
        return Motion.Steady.IsAtLimit() || Threads.IsAnyReleased();
    }

    private void StepMotion()
    {
        _recorder.Before(Sample);
        _recorder.After(Sample, Motion.Step());
        if (Motion.Contour.HadUnderrun && Motion.Contour.TakeLateness()) LastError = Tc.ContourTooSlow;

        for (var hits = Motion.TakeLimitHits(); hits > 0; hits--) Threads.Interrupt("LIMSWI");
        for (var hits = Motion.TakeErrorHits(); hits > 0; hits--) Threads.Interrupt("POSERR");
    }
}
