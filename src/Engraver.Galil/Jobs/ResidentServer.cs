using Engraver.Galil.Profiles;

namespace Engraver.Galil.Jobs;

/// <summary>What the job and the program downloaded for it have agreed on: threads, variables, operations (galil-dmc.md EX11, EX12, F.3).</summary>
internal static class ResidentServer
{
    public const int ServerThread = 0;
    public const int WatchdogThread = 1;

    /// <summary>Winds the watchdog up: 20 turns of 50 ms.</summary>
    public const string HeartbeatCommand = "hb=20";

    /// <summary>Gives every variable a value before anything reads it: an undefined one is refused.</summary>
    public const string DefineVariables = "hb=20;wtrip=0;seq=0;go=0";

    public const string StartWatchdog = "XQ #WDOG,1";
    public const string StartServer = "XQ #SERVER,0";

    public static string Text(MachineProfile profile) => string.Join('\n', Lines(profile.ToolOutput, profile.AccelerationCounts));

    private static string[] Lines(int tool, int acceleration) =>
    [
        "#SERVER", "op=0;x=0;y=0;r=0;th=0;da=0;f=5000", $"VAS={acceleration};VDS={acceleration}", "go=0;seq=0",
        "#SLOOP", "WT 2", "JP#SLOOP,go=0", "IF (op=1)", "JS#LINEAR", "ENDIF", "IF (op=2)", "JS#CIRC", "ENDIF", "go=0;seq=seq+1", "JP#SLOOP", "EN",
        "#LINEAR", "VMAB", "VSS=f", "VP x,y", "VE", "BGS", "AMS", "EN",
        "#CIRC", "VMAB", "VSS=f", "CR r,th,da", "VE", "BGS", "AMS", "EN",
        "#WDOG", "wtrip=0", "hb=20", "#WLOOP", "WT 50", "hb=hb-1", "JP#WLOOP,hb>0", $"CB{tool};STS;STAB", "wtrip=1", "MG \"HOST LOST\"", "EN",
        "#CMDERR", $"CB{tool};STS;STAB", "MG \"CMDERR\",_TC,_ED0", "EN",
    ];
}
