using System.Collections.Concurrent;
using System.Diagnostics;

namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>A program that reports its actions line by line; tests wait for lines, never for time.</summary>
internal sealed class ToldProcess : IDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(30); // only a failing test waits that long
    private readonly Process _process;
    private readonly BlockingCollection<string> _lines = [];
    private readonly ConcurrentQueue<string> _heard = new();

    public ToldProcess(string program, string? display, params ReadOnlySpan<string> arguments)
    {
        var start = new ProcessStartInfo(program) { RedirectStandardInput = true, RedirectStandardOutput = true, RedirectStandardError = true };
        foreach (var argument in arguments) start.ArgumentList.Add(argument);
        if (display is not null) start.Environment["DISPLAY"] = display;
        start.Environment["LC_ALL"] = "C.UTF-8";
        start.Environment.Remove("XMODIFIERS");
        _process = Process.Start(start)!;
        _process.OutputDataReceived += (_, e) => Hear(e.Data);
        _process.ErrorDataReceived += (_, e) => HearError(e.Data);
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    /// <summary>The process id.</summary>
    public int Id => _process.Id;

    /// <summary>All lines so far, including errors.</summary>
    public IReadOnlyCollection<string> Heard => [.. _heard];

    public void Ask(string line)
    {
        _process.StandardInput.WriteLine(line);
        _process.StandardInput.Flush();
    }

    /// <summary>The next line with this start; lines before it are skipped.</summary>
    public string WaitFor(string beginning)
    {
        using var patience = new CancellationTokenSource(Patience);
        try
        {
            while (true)
            {
                var line = _lines.Take(patience.Token);
                if (line.StartsWith(beginning, StringComparison.Ordinal)) return line;
            }
        }
        catch (Exception e) when (e is OperationCanceledException or InvalidOperationException)
        {
            throw new InvalidOperationException($"\"{beginning}\" was never said. Heard: {string.Join(" / ", _heard)}", e);
        }
    }

    /// <summary>Whether a line with this start is printed within the time; lines before it are skipped.</summary>
    public bool HearsWithin(string beginning, TimeSpan time)
    {
        using var patience = new CancellationTokenSource(time);
        try
        {
            while (!_lines.Take(patience.Token).StartsWith(beginning, StringComparison.Ordinal))
            {
            }

            return true;
        }
        catch (Exception e) when (e is OperationCanceledException or InvalidOperationException)
        {
            return false;
        }
    }

    public int WaitForExit()
    {
        if (!_process.WaitForExit(Patience)) throw new InvalidOperationException($"The program does not end. Heard: {string.Join(" / ", _heard)}");
        _process.WaitForExit(); // and until its last line has been read
        return _process.ExitCode;
    }

    public void Kill() => _process.Kill();

    public void Dispose()
    {
        if (!_process.HasExited) _process.Kill(entireProcessTree: true);
        _process.WaitForExit();
        _process.Dispose();
    }

    private void Hear(string? line)
    {
        if (line is null)
        {
            _lines.CompleteAdding();
            return;
        }

        _heard.Enqueue(line);
        _lines.Add(line);
    }

    private void HearError(string? line)
    {
        if (line is not null) _heard.Enqueue("error: " + line);
    }
}
