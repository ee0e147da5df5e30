namespace Engraver.Simulator.Tests;

/// <summary>The example programs of galil-dmc.md section H, verbatim.</summary>
internal static class ExamplePrograms
{
    public const string Line = """
        #LINEAR
        SHAB
        VMAB
        VS 5000
        VA 102400
        VD 102400
        VP x,y
        VE
        BGS
        AMS
        EN
        """;

    public const string Arc = """
        #ARC
        SHAB
        VMAB
        VS 10000;VA 256000;VD 256000
        CR 2500,0,180
        VE
        BGS
        AMS
        EN
        """;

    public const string Circle = """
        #CIRCLE
        SHAB
        VMAB
        VS 8000;VA 204800;VD 204800
        CR 2000,90,-360
        VE
        SB1
        WT 100
        BGS
        AMS
        CB1
        WT 100
        EN
        """;

    public const string Track = """
        #TRACK
        SHAB
        VMAB
        VS 20000;VA 512000;VD 512000
        VP -4000,0
        CR 1500,270,-180
        VP 0,3000
        CR 1500,90,-180
        VE
        BGS
        AMS
        EN
        """;

    public const string Draw = """
        #DRAW
        SHAB
        CB1
        SPA=20000;SPB=20000
        PAA=5000;PAB=5000
        BGAB
        AMAB
        VMAB
        VS 10000;VA 256000;VD 256000
        VP 10000,0
        VP 10000,10000
        CR 5000,0,180
        VP 0,0
        VE
        SB1
        WT 200
        BGS
        AMS
        CB1
        WT 200
        MG "DONE",_RPA,_RPB
        EN
        """;

    public const string Knife = """
        #KNIFE
        SHABC
        CB1
        VMABC
        TN 2000/360,-500
        CR 3000,0,180
        VE
        PAA=3000;PAB=0;PAC=_TNS
        SPA=20000;SPB=20000;SPC=4000
        BGABC
        AMABC
        SB1
        WT 50
        VS 6000;VA 128000;VD 128000
        BGS
        AMS
        CB1
        EN
        """;

    public const string Linear3D = """
        #LIN3D
        SHABC
        LMABC
        VS 10000;VA 256000;VD 256000
        LI 4000,3000,0
        LI 0,0,-1200
        LI -4000,-3000,1200
        LE
        BGS
        AMS
        EN
        """;

    public const string HomeOnLimit = """
        #HOMEA
        homed=0
        SHA
        ACA=256000;DCA=256000
        IF (_LRA=1)
        JGA=-4000
        BGA
        AMA
        ENDIF
        SPA=2000
        PRA=2000
        BGA
        MCA
        DPA=0
        homed=1
        MG "HOMED A",_RPA
        EN
        """;

    public const string Handlers = """
        #AUTO
        nerr=0;lerr=0;nlim=0;npos=0
        #IDLE
        WT 10
        JP#IDLE
        EN
        #BAD
        SPA=20000
        SPA=99999999
        nerr=-1
        EN
        #CMDERR
        nerr=nerr+1
        lerr=_TC
        MG "CMDERR",_TC
        EN1
        #LIMSWI
        nlim=nlim+1
        STS
        CB1
        MG "LIMIT",_SCA,_SCB
        RE1
        #POSERR
        npos=npos+1
        AB1
        CB1
        MG "POSERR",_TEA,_TEB
        RE1
        """;

    public const string Stream = """
        #STREAM
        DM px[601],py[601]
        i=0
        #FILL
        px[i]=@RND[5000*@COS[i*3/5]]
        py[i]=@RND[5000*@SIN[i*3/5]]
        i=i+1
        JP#FILL,i<=600
        SHAB
        LMAB
        VS 10000;VA 256000;VD 256000
        i=0
        started=0
        #FEED
        IF (_LM=0)&(started=0)
        BGS
        started=1
        ENDIF
        JP#FEED,_LM=0
        dx=px[i+1]-px[i]
        dy=py[i+1]-py[i]
        LI dx,dy
        i=i+1
        JP#FEED,i<600
        LE
        IF (started=0)
        BGS
        ENDIF
        AMS
        MG "END",_RPA,_RPB
        EN
        """;

    public const string Server = """
        #SERVER
        op=0;x=0;y=0;r=0;th=0;da=0;f=5000
        go=0;done=1;seq=0
        VA 256000;VD 256000
        SHAB
        #SLOOP
        WT 2
        JP#SLOOP,go=0
        done=0
        IF (op=1)
        JS#SLIN
        ENDIF
        IF (op=2)
        JS#SARC
        ENDIF
        IF (op=3)
        JS#SRAP
        ENDIF
        IF (op=4)
        JS#SPEN
        ENDIF
        seq=seq+1
        go=0;done=1
        JP#SLOOP
        EN
        #SLIN
        VMAB
        VS f
        VP x,y
        VE
        BGS
        AMS
        EN
        #SARC
        VMAB
        VS f
        CR r,th,da
        VE
        BGS
        AMS
        EN
        #SRAP
        SPA=20000;SPB=20000
        PAA=x;PAB=y
        BGAB
        AMAB
        EN
        #SPEN
        OB 1,x
        WT 150
        EN
        """;

    public const string Watchdog = """
        #WDOG
        wtrip=0
        hb=20
        #WLOOP
        WT 50
        hb=hb-1
        JP#WLOOP,hb>0
        STS
        CB1
        wtrip=1
        MG "HOST LOST"
        EN
        """;

    public const string Square = """
        #SPEEDS
        SHAB
        VMAB
        VS 20000;VA 256000;VD 256000
        VP 10000,0<20000>2000
        VP 10000,10000<20000>2000
        VP 0,10000<20000>2000
        VP 0,0<20000
        VE
        BGS
        AMS
        EN
        """;
}
