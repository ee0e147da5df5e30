using System.Diagnostics;
using System.Runtime.InteropServices;
using System.Runtime.Versioning;

namespace Engraver.Cli.Tests;

/// <summary>The program as a separate process, for tests that require one: signals, a killed host, two programs on one socket.</summary>
internal sealed class EngraverProcess : IDisposable
{
    private readonly Process _process;

    private EngraverProcess(Process process) => _process = process;

    public int ExitCode => _process.ExitCode;

    /// <summary>Standard input; empty and open until something is written.</summary>
    public StreamWriter In => _process.StandardInput;

    public StreamReader Out => _process.StandardOutput;

    public StreamReader Error => _process.StandardError;

    private static string Program => Path.Combine(AppContext.BaseDirectory, "engraver.dll");

    public static EngraverProcess Start(params string[] args) => Start("dotnet", [Program, .. args]);

    /// <summary>As a shell without job control starts a background command: with the interrupt ignored.</summary>
    public static EngraverProcess StartInBackground(params string[] args) => Start("sh", ["-c", "trap '' INT; exec dotnet \"$@\"", "sh", Program, .. args]);

    /// <summary>With <see cref="StartupHook"/>: the signal <see cref="StartupHook.Trigger"/> makes a pool thread throw.</summary>
    public static EngraverProcess StartWithBug(params string[] args) => Start("dotnet", [Program, .. args], ("DOTNET_STARTUP_HOOKS", typeof(StartupHook).Assembly.Location));

    /// <summary>A script of the samples, which runs the program that is tested.</summary>
    /// <param name="folder">Gets the start of the program.</param>
    [UnsupportedOSPlatform("windows")]
    public static EngraverProcess StartScript(string folder, string script, params string[] args)
    {
        var program = Path.Combine(folder, "engraver");
        File.WriteAllText(program, $"#!/bin/sh\nexec dotnet '{Program}' \"$@\"\n");
        File.SetUnixFileMode(program, UnixFileMode.UserRead | UnixFileMode.UserExecute);
        return Start("bash", [script, .. args], ("ENGRAVER", program));
    }

    private static EngraverProcess Start(string command, IEnumerable<string> args, (string Name, string Value)? setting = null)
    {
        var start = new ProcessStartInfo(command) { RedirectStandardInput = true, RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false };
        if (setting is { } variable) start.Environment[variable.Name] = variable.Value;
        foreach (var arg in args) start.ArgumentList.Add(arg);
        return new EngraverProcess(Process.Start(start) ?? throw new InvalidOperationException("dotnet did not start."));
    }

    /// <summary>Reads standard output up to the first line with this prefix, and returns it.</summary>
    public async Task<string> LineAsync(string beginning, CancellationToken cancellation)
    {
        while (await _process.StandardOutput.ReadLineAsync(cancellation) is { } line)
        {
            if (line.StartsWith(beginning, StringComparison.Ordinal)) return line;
        }

        throw new EndOfStreamException($"The program ended without saying '{beginning}'.");
    }

    public Task WaitAsync(CancellationToken cancellation) => _process.WaitForExitAsync(cancellation);

    public void Kill() => _process.Kill();

    public void Signal(PosixSignal signal)
    {
        var number = signal switch { PosixSignal.SIGINT => 2, PosixSignal.SIGTERM => 15, StartupHook.Trigger => (int)StartupHook.Trigger, _ => throw new ArgumentOutOfRangeException(nameof(signal)) };
        if (NativeMethods.Kill(_process.Id, number) != 0) throw new InvalidOperationException($"kill failed: {Marshal.GetLastPInvokeErrorMessage()}");
    }

    public void Dispose()
    {
        if (!_process.HasExited) _process.Kill();
        _process.Dispose();
    }

    private static class NativeMethods
    {
        [DllImport("libc", EntryPoint = "kill", SetLastError = true)]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern int Kill(int process, int signal);
    }
}
