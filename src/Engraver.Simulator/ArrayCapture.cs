using Engraver.Simulator.Values;

namespace Engraver.Simulator;

/// <summary>RA, RD, RC (galil-dmc.md E, Array): every 2^n samples, one value of each source is stored in the next element of its array.</summary>
internal sealed class ArrayCapture(Machine machine)
{
    private long _last;
    private int _period;
    private int _length;
    private bool _isCircular;

    /// <summary>The arrays named by RA, in order.</summary>
    public IReadOnlyList<FixedPoint[]> Arrays { get; set; } = [];

    /// <summary>The sources named by RD, in the same order.</summary>
    public IReadOnlyList<Func<FixedPoint>> Sources { get; set; } = [];

    /// <summary>True while a capture is running: <c>_RC</c>.</summary>
    public bool IsOn { get; private set; }

    /// <summary>The element that is filled next: <c>_RD</c>.</summary>
    public int Next { get; private set; }

    /// <summary>Captures since power up that ended because their arrays were full.</summary>
    public long Ends { get; private set; }

    /// <summary>The sample in which the next value is due; long.MaxValue when no value is due.</summary>
    public long NextDue => IsOn ? _last + (long)Math.Max(1, _period / machine.SamplesPerMillisecond) : long.MaxValue;

    /// <param name="period">Samples of TM from one value to the next.</param>
    /// <param name="length">Elements to fill. A negative number overwrites repeatedly from the first element; 0 fills as many elements as the shortest array
    /// has.</param>
    /// <exception cref="CommandRefusedException">TC 80 while recording; TC 81 unless there is an array for each source; TC 84 for more elements than the
    /// shortest array has.</exception>
    public void Start(int period, int length)
    {
        if (IsOn) throw new CommandRefusedException(Tc.AlreadyRecording);
        if (Arrays.Count == 0 || Sources.Count != Arrays.Count) throw new CommandRefusedException(Tc.NothingToRecord);
        var shortest = Arrays.Min(a => a.Length);
        if (Math.Abs((long)length) > shortest) throw new CommandRefusedException(Tc.TooManyElements);
        _length = length == 0 ? shortest : Math.Abs(length);
        _isCircular = length < 0;
        _period = period;
        _last = machine.Sample;
        Next = 0;
        IsOn = true;
    }

    public void Stop() => IsOn = false;

    /// <summary>Stores one value of each source when the sample <see cref="NextDue"/> is reached.</summary>
    public void Step()
    {
        if (!IsOn || machine.Sample < NextDue) return;
        _last = machine.Sample;
        for (var i = 0; i < Arrays.Count; i++) Arrays[i][Next] = Sources[i]();
        Next++;
        if (Next < _length) return;
        IsOn = _isCircular;
        Next = _isCircular ? 0 : Next;
        Ends += IsOn ? 0 : 1;
    }
}
