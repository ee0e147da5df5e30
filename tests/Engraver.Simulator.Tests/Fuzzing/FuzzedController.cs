using System.Text;

namespace Engraver.Simulator.Tests.Fuzzing;

/// <summary>One controller in virtual time that receives seeded lines and bytes, operation of its switches and passing time. After each of them it must still
/// reply.</summary>
internal sealed class FuzzedController : IAsyncDisposable
{
    /// <summary>Lines between two queries that must be answered.</summary>
    private const int Round = 25;

    private readonly int _seed;
    private readonly Random _random;
    private readonly StatementSource _source;
    private readonly StoppedTimeProvider _time = new();
    private readonly SimulatedController _controller;
    private readonly List<string> _recent = [];
    private Stream _network;
    private Stream _serial;

    public FuzzedController(int seed)
    {
        (_seed, _random) = (seed, new Random(seed));
        _source = new StatementSource(_random);
        _controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = _time, HandleCount = _random.Next(2) == 0 ? 8 : 2, HandlersNeedThreadZero = _random.Next(2) == 0 });
        (_network, _serial) = (_controller.OpenConnection(), _controller.OpenSerialConnection(115200));
    }

    /// <returns>Null; or the seed, the failure, and the lines that led to it.</returns>
    public string? Run(int lines)
    {
        var line = 0;
        try
        {
            for (line = 1; line <= lines; line++)
            {
                Send();
                if (line % Round == 0 && FindFailureToReply() is { } silence) return Report(line, silence);
            }
        }
        catch (Exception bug)
        {
            return Report(line, bug.ToString());
        }

        return null;
    }

    public async ValueTask DisposeAsync()
    {
        await _network.DisposeAsync();
        await _serial.DisposeAsync();
        await _controller.DisposeAsync();
    }

    private void Send()
    {
        switch (_random.Next(30))
        {
            case 0:
                foreach (var statement in _source.Motion()) SendLine(statement + "\r");
                break;
            case 1:
                SendLine("AB;ST;HX\r"); // no program must run
                SendLine("DL\r" + string.Join('\r', _source.Program()) + "\\");
                SendLine($"XQ#A,{_random.Next(0, 9)}\r");
                SendLine("XQ#B,1;XQ\r");
                break;
            case 2:
                OperateInputs();
                break;
            case 3:
                Pass();
                break;
            case 4:
                var bytes = new byte[_random.Next(1, 40)];
                _random.NextBytes(bytes);
                SendLine(Encoding.Latin1.GetString(bytes));
                break;
            case 5:
                SendLine(string.Concat(_source.Line().Where(_ => _random.Next(6) != 0)) + "\r");
                break;
            default:
                SendLine(_source.Line() + (_random.Next(10) == 0 ? ";" : "\r"));
                break;
        }
    }

    private void SendLine(string text)
    {
        _recent.Add(text);
        var serial = _random.Next(12) == 0;
        try
        {
            (serial ? _serial : _network).Write(Encoding.Latin1.GetBytes(text));
        }
        catch (IOException)
        {
            Reconnect(); // the line before closed the connection, as IHS and RS do
        }
    }

    private void Reconnect()
    {
        _network.Dispose();
        _serial.Dispose();
        (_network, _serial) = (_controller.OpenConnection(), _controller.OpenSerialConnection(115200));
    }

    private void Pass()
    {
        _recent.Add("(time passes)");
        if (_random.Next(2) == 0) _controller.Advance(TimeSpan.FromMilliseconds(_random.Next(1, 60)));
        else _time.Advance(TimeSpan.FromMilliseconds(_random.Next(1, 30)));
    }

    private void OperateInputs()
    {
        var (axis, on) = (_random.Next(4), _random.Next(2) == 0);
        _recent.Add($"(hand on axis {axis}: {on})");
        switch (_random.Next(6))
        {
            case 0: _controller.SetLimitSwitch(axis, _random.Next(2) == 0, on); break;
            case 1: _controller.SetHomeSwitch(axis, on); break;
            case 2: _controller.HoldMotor(axis, on); break;
            case 3: _controller.SetInput(_random.Next(1, 9), on); break;
            case 4: _controller.SetAbortInput(on); break;
            default: _controller.DropConnections(); break;
        }
    }

    /// <summary>After any input: the end of a text and the end of a line are sent, and then the next query is answered, on every connection.</summary>
    private string? FindFailureToReply()
    {
        Ask(() => _network, "\\\r\"\rCI0;\r"); // no program owns the serial port
        if (_controller.Broken is { IsFaulted: true, Exception: { } bug }) return bug.ToString();
        foreach (var (name, open) in new (string, Func<Stream>)[] { ("network", () => _network), ("serial", () => _serial) })
        {
            Ask(open, "\\\r\"\r");
            var answer = Ask(open, "MG\"alive\"\r");
            if (!answer.Contains("alive\r\n:", StringComparison.Ordinal)) return $"the {name} connection is silent: '{answer}'";
        }

        _recent.RemoveRange(0, Math.Max(0, _recent.Count - (4 * Round)));
        return null;
    }

    private string Ask(Func<Stream> open, string text)
    {
        SimulatorRig.ReadAvailable(open());
        try
        {
            open().Write(Encoding.Latin1.GetBytes(text));
        }
        catch (IOException)
        {
            Reconnect();
            open().Write(Encoding.Latin1.GetBytes(text));
        }

        return SimulatorRig.ReadAvailable(open());
    }

    private string Report(int line, string what) =>
        $"seed {_seed}, line {line}: {what}\nThe lines before, the last one last:\n{string.Join('\n', _recent.TakeLast(30).Select(l => l.Replace("\r", "\\r", StringComparison.Ordinal)))}";
}
