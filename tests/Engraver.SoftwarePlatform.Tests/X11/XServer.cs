using System.Diagnostics;

namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>An X server without a screen, on a free display, with a window manager, and the simulated input of other programs.</summary>
internal sealed class XServer : IDisposable
{
    private readonly LineProcess _server;
    private readonly LineProcess? _manager;

    /// <param name="screenFolder">The folder in which the server keeps its screen as a file that can be read at any time; null: none.</param>
    public XServer(bool withWindowManager = true, string? screenFolder = null)
    {
        string[] kept = screenFolder is null ? [] : ["-fbdir", screenFolder];
        _server = new LineProcess("Xvfb", null, ["-displayfd", "1", "-screen", "0", "1280x900x24", "-nolisten", "tcp", "-noreset", .. kept]);
        Display = ":" + FirstLine(_server);
        if (!withWindowManager) return;
        _manager = new LineProcess("openbox", Display, "--sm-disable", "--config-file", "/dev/null", "--startup", "echo ready");
        _manager.WaitFor("ready");
    }

    public string Display { get; }

    /// <summary>Runs a program to its end and returns its output.</summary>
    public string Run(string program, params ReadOnlySpan<string> arguments) => RunWith(null, program, arguments);

    public string RunWith(string? input, string program, params ReadOnlySpan<string> arguments)
    {
        var start = new ProcessStartInfo(program) { RedirectStandardOutput = true, RedirectStandardInput = input is not null };
        foreach (var argument in arguments) start.ArgumentList.Add(argument);
        start.Environment["DISPLAY"] = Display;
        start.Environment["LC_ALL"] = "C.UTF-8";
        using var process = Process.Start(start)!;
        if (input is not null)
        {
            process.StandardInput.Write(input);
            process.StandardInput.Close();
        }

        var said = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.True(process.ExitCode == 0, $"{program} ended with {process.ExitCode}");
        return said;
    }

    /// <summary>A program that offers its input as the clipboard until another owner takes it. It may own the clipboard only some time after this
    /// returns.</summary>
    public void OfferClipboard(string text)
    {
        var start = new ProcessStartInfo("xclip") { RedirectStandardInput = true };
        foreach (var argument in new[] { "-selection", "clipboard", "-i" }) start.ArgumentList.Add(argument);
        start.Environment["DISPLAY"] = Display;
        start.Environment["LC_ALL"] = "C.UTF-8";
        using var process = Process.Start(start)!;
        process.StandardInput.Write(text);
        process.StandardInput.Close();
        process.WaitForExit();
    }

    public void Click(int x, int y, int button = 1) => Run("xdotool", "mousemove", Text(x), Text(y), "click", Text(button));

    public void Press(string keys) => Run("xdotool", "key", keys);

    public void Kill() => _server.Kill();

    public void Dispose()
    {
        _manager?.Dispose();
        _server.Dispose();
    }

    private static string Text(int number) => number.ToString(System.Globalization.CultureInfo.InvariantCulture);

    private static string FirstLine(LineProcess process) => process.WaitFor("");
}
