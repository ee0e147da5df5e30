using System.Collections.Concurrent;
using System.Diagnostics;

namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>A program that reports its actions line by line; tests wait for lines, never for time.</summary>
internal sealed class LineProcess : IDisposable
{
    private static readonly TimeSpan Timeout = TimeSpan.FromSeconds(30); // only a failing test waits that long
    private readonly Process _process;
    private readonly BlockingCollection<string> _lines = [];
    private readonly ConcurrentQueue<string> _allLines = new();

    public LineProcess(string program, string? display, params ReadOnlySpan<string> arguments)
    {
        var start = new ProcessStartInfo(program) { RedirectStandardInput = true, RedirectStandardOutput = true, RedirectStandardError = true };
        foreach (var argument in arguments) start.ArgumentList.Add(argument);
        if (display is not null) start.Environment["DISPLAY"] = display;
        start.Environment["LC_ALL"] = "C.UTF-8";
        start.Environment.Remove("XMODIFIERS");
        _process = Process.Start(start)!;
        _process.OutputDataReceived += (_, e) => OnOutput(e.Data);
        _process.ErrorDataReceived += (_, e) => OnErrorOutput(e.Data);
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    /// <summary>The process id.</summary>
    public int Id => _process.Id;

    /// <summary>All lines so far, including errors.</summary>
    public IReadOnlyCollection<string> Lines => [.. _allLines];

    public void Send(string line)
    {
        _process.StandardInput.WriteLine(line);
        _process.StandardInput.Flush();
    }

    /// <summary>The next line with this start; lines before it are skipped.</summary>
    public string WaitFor(string beginning)
    {
        using var patience = new CancellationTokenSource(Timeout);
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
            throw new InvalidOperationException($"\"{beginning}\" was never said. Heard: {string.Join(" / ", _allLines)}", e);
        }
    }

    /// <summary>Whether a line with this start is printed within the time; lines before it are skipped.</summary>
    public bool PrintsWithin(string beginning, TimeSpan time)
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
        if (!_process.WaitForExit(Timeout)) throw new InvalidOperationException($"The program does not end. Heard: {string.Join(" / ", _allLines)}");
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

    private void OnOutput(string? line)
    {
        if (line is null)
        {
            _lines.CompleteAdding();
            return;
        }

        _allLines.Enqueue(line);
        _lines.Add(line);
    }

    private void OnErrorOutput(string? line)
    {
        if (line is not null) _allLines.Enqueue("error: " + line);
    }
}
