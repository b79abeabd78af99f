"""Exports of bending tests as twelve machines and people write them, made by someone who had not seen the reader."""
import math

import numpy as np
import openpyxl

OUT = ""

def I_rect(b, h): return b * h**3 / 12
def I_round(d): return math.pi * d**4 / 64
def stiff(E_MPa, I, L): return 48 * E_MPa * I / L**3          # N/mm (or µN/µm)

def curve(k, dmax, n, rng, kind='linear', at=None, slips=0, noise=0.0, pre=0.0, soft=0.97, drop=0.07):
    """displacement d (0..dmax), force f, number of slips."""
    d = np.linspace(0, dmax, n)
    x = np.clip(d - pre, 0, None)                              # contact at pre
    f = k * x
    if kind == 'break':
        f[d > at] = 0
    if kind == 'saw':
        where = np.sort(rng.uniform(at, dmax * 0.97, slips * 4))
        step = (dmax * 0.97 - at) / slips
        pos = [at + step * (i + 0.25 * rng.uniform(-1, 1)) for i in range(slips)]
        idx = [int(np.searchsorted(d, p)) for p in pos]
        kk, prev = k, 0
        f = np.zeros(n); cur = 0.0
        for i in range(1, n):
            if d[i] > pre: cur += kk * min(d[i] - d[i-1], d[i] - pre)
            if i in idx:
                cur *= 1 - drop * rng.uniform(0.7, 1.3); kk *= soft
            f[i] = cur
    return d, f + rng.normal(0, noise, n)

def wr(name, text, enc, nl='\r\n'):
    with open(OUT + name, 'wb') as g: g.write(text.replace('\n', nl).encode(enc))

# 1 Instron Bluehill 3, US units, quoted, thousands commas, results table on top
def bluehill():
    rng = np.random.default_rng(1); inch, lbf = 25.4, 4.4482216
    L, b, h, E = 4.0, 0.5, 0.25, 205000.0
    k = stiff(E, I_rect(b*inch, h*inch), L*inch)
    d, f = curve(k, 0.121*inch, 606, rng, 'break', at=0.1185*inch, noise=1.0)
    d /= inch; f /= lbf
    s = 3*f*L/(2*b*h*h); e = 6*d*h/L**2*100
    q = lambda v, p: '"' + f'{v:,.{p}f}' + '"'
    t = '"Results Table 1"\n"","Specimen label","Maximum Flexure load (lbf)","Flexure stress at Maximum Flexure load (psi)","Flexure extension at Maximum Flexure load (in)","Modulus (Automatic) (psi)"\n'
    t += f'"1","D2-HT-01",{q(f.max(),2)},{q(s.max(),1)},{q(d[f.argmax()],4)},{q(E*145.038,0)}\n\n'
    t += '"Specimen properties"\n"Geometry","Rectangular",""\n"Width","0.50000","in"\n"Thickness","0.25000","in"\n"Support span","4.00000","in"\n"Rate 1","0.06000","in/min"\n\n'
    t += '"Raw Data"\n"Time","Flexure extension","Flexure load","Flexure stress","Flexure strain"\n"(sec)","(in)","(lbf)","(psi)","(%)"\n'
    for i in range(len(d)):
        t += ','.join([q(i*0.2,5), q(d[i],5), q(f[i],5), q(s[i],3), q(e[i],5)]) + '\n'
    wr('bluehill_us.csv', t, 'utf-8-sig')

# 2 MTS 793 MPT specimen.dat, two acquisition blocks, compression negative, kN
def mts():
    rng = np.random.default_rng(2); L, b, h, E = 160., 15., 10., 38000.
    k = stiff(E, I_rect(b, h), L)
    d, f = curve(k, 5.4, 540, rng, 'break', at=5.2, noise=1.5)
    npre = 15
    t = 'MTS793|MPT|ENU|1|2|.|/|:|1|0|0|A\n\nStation Name:\tFrame 4 370.10 100kN.cfg\nTest File Name:\t3PB flexure monotonic.000\nSpecimen:\tGFRP-UD-07\n\n'
    t0, clock = 3.2001953, 0
    def block(name, lo, hi):
        s = f'Data Acquisition: {name}\t\tTime:\t{t0+lo*0.1:.7g}\tSec\t11/3/2026 2:11:0{3+(lo>0)} PM\n'
        s += 'Running Time\tAxial Displacement\tAxial Force\tAxial Count\nsec\tmm\tkN\tsegments\n'
        for i in range(lo, hi):
            s += f'{t0+i*0.1:.7f}\t{-(d[i]+12.0312):.6f}\t{-(f[i])/1000:.7f}\t{0 if lo==0 else 1}\n'
        return s + '\n'
    t += block('Preload DAQ', 0, npre) + block('Ramp DAQ', npre, len(d))
    wr('mts_specimen.dat', t, 'cp1252')

# 3 ZwickRoell testXpert III xlsx, German: results, statistics and a sheet per specimen
def zwick():
    rng = np.random.default_rng(3); L, b, h = 64., 10., 4.
    wb = openpyxl.Workbook(); ws = wb.active; ws.title = 'Ergebnisse'
    ws.append([None, 'Probenbezeichnung', 'E-Modul', 'σfM', 'εfM', 'h', 'b']); ws.append([None, None, 'MPa', 'MPa', '%', 'mm', 'mm'])
    st = wb.create_sheet('Statistik'); pr = wb.create_sheet('Parameter')
    for r in [['Kunde', 'TU Dresden ILK'], ['Prüfnorm', 'ISO 178'], ['Prüfer', 'K. Müller'], ['Vorkraft', 0.1, 'MPa'], ['Geschwindigkeit E-Modul', 2, 'mm/min'], ['Stützweite', 64, 'mm'], ['Kraftaufnehmer', '2,5 kN'], ['Maschinendaten', 'Zwick Z010 WN:189341']]: pr.append(r)
    info = []
    for j, (E, n) in enumerate([(18400., 505), (18950., 471)]):
        k = stiff(E, I_rect(b, h), L)
        trav = np.linspace(0, 2.5*n/505, n); brk = 2.458*n/505     # the crosshead moves evenly; the frame yields F/4200
        d = np.where(trav <= brk, trav/(1 + k/4200), trav)
        f = np.where(trav <= brk, k*d, 0) + rng.normal(0, 0.15, n)
        f = f + 1.7*(trav <= brk)                                 # preload 0.1 MPa
        ws.append([j+1, f'CF30-{j+1}', round(E, 0), round(3*f.max()*L/(2*b*h*h), 1), round(6*d[f.argmax()]*h/L**2*100, 2), 4.0, 10.0])
        s = wb.create_sheet(f'Probe {j+1}')
        s.append([f'CF30-{j+1}']); s.append(['Prüfzeit', 'Standardkraft', 'Verformung', 'Traversenweg']); s.append(['s', 'N', 'mm', 'mm'])
        for i in range(n): s.append([round(i*0.14, 3), float(f[i]), float(d[i]), float(trav[i])])
        info.append(n)
    st.append(['Serie', 'E-Modul', 'σfM']); st.append(['n = 2', 'MPa', 'MPa']); st.append(['x', 18675, 531.0]); st.append(['s', 389, 4.1]); st.append(['ν [%]', 2.08, 0.77])
    wb.save(OUT + 'zwick_testxpert3.xlsx')

# 4 Shimadzu Trapezium-X csv, Japanese, Shift-JIS, two specimens side by side, of different lengths
def shimadzu():
    rng = np.random.default_rng(4); L, b, h = 48., 10., 3.; cols = []
    for E, n in [(3100., 721), (3320., 655)]:
        k = stiff(E, I_rect(b, h), L)
        d, f = curve(k, n*0.005, n, rng, 'break', at=(n-12)*0.005, noise=0.05)
        cols.append((d, f))
    t = '"試験名称","エポキシ曲げ試験","","","",""\n"試験日","2026/11/03","","","",""\n"試験モード","シングル","試験種類","3点曲げ","",""\n\n'
    t += '"1 _ 1","","","1 _ 2","",""\n"時間","試験力","ストローク","時間","試験力","ストローク"\n"sec","N","mm","sec","N","mm"\n'
    for i in range(721):
        row = []
        for d, f in cols:
            row += [f'"{i*0.3:.2f}"', f'"{f[i]:.5f}"', f'"{d[i]:.6f}"'] if i < len(d) else ['""']*3
        t += ','.join(row) + '\n'
    wr('shimadzu_ja.csv', t, 'shift_jis')

# 5 TA.XTplus Texture Exponent, tab, force in g, distance counted from a 5 g trigger
def taxt():
    rng = np.random.default_rng(5); L, dia, E = 40., 1.75, 2900.
    k = stiff(E, I_round(dia), L); off = 5*9.80665e-3/k
    d, f = curve(k, 3.6, 900, rng, 'linear', noise=0.002); f = f + 5*9.80665e-3; f[d > 3.2] = rng.normal(0, 0.002, (d > 3.2).sum())
    t = 'Spaghetti no 5 - 01\t\t\nForce (g)\tDistance (mm)\tTime (sec)\n'
    for i in range(len(d)): t += f'{f[i]/9.80665e-3:.3f}\t{d[i]:.4f}\t{i*0.008:.3f}\n'
    wr('texture_exponent.tab', t, 'cp1252')

# 6 Bruker Hysitron, load - hold - unload, µ in Windows-1252, also in volts
def hysitron():
    rng = np.random.default_rng(6); L, b, h, E = 60., 10., 2., 250000.
    k = stiff(E, I_rect(b, h), L)                                 # µN/µm
    n = 1500; tt = np.arange(n)/60.
    P = np.where(tt < 10, 30*tt, np.where(tt < 15, 300, np.clip(300-30*(tt-15), 0, None)))
    D = P/k*1000 + rng.normal(0, 0.25, n); Pm = P + rng.normal(0, 0.12, n)
    t = '\nNumber of Points = 1500\n\nDepth (nm)\tLoad (µN)\tTime (s)\tDepth (V)\tLoad (V)\n'
    for i in range(n): t += f'{D[i]:.6f}\t{Pm[i]:.6f}\t{tt[i]:.6f}\t{D[i]*2.1e-4-0.31:.6f}\t{Pm[i]*1.9e-3+0.02:.6f}\n'
    wr('hysitron_bridge.txt', t, 'cp1252')

# 7 FemtoTools FT-NMT, tab, brackets, index and phase, two force channels, positions; 24 slips
def femto():
    rng = np.random.default_rng(7); L, dia, E = 1500., 50., 38000.
    k = stiff(E, I_round(dia), L)
    d, f = curve(k, 180., 1800, rng, 'saw', at=40., slips=24, noise=8.)
    t = 'FT-NMT04 Data File\tVersion 2.4.1\nMeasurement Name\tspicule_A12_3PB\nDate\t03.11.2026\nTime\t14:02:11\nSensor Type\tFT-S200000\nSensor Serial Number\tS200-1187\nSensor Gain A [uN/V]\t100000\nSensor Gain B [uN/V]\t10000\nControl Mode\tDisplacement Controlled\nStep Size [um]\t0.1\n\n'
    t += 'Index [#]\tPhase [#]\tTime [s]\tDisplacement [um]\tForce A [uN]\tForce B [uN]\tPiezo Z [um]\tPos X [um]\tPos Y [um]\tPos Z [um]\n'
    for i in range(len(d)):
        t += f'{i}\t1\t{i*0.05:.3f}\t{d[i]:.5f}\t{f[i]:.4f}\t{0:.4f}\t{d[i]%20:.4f}\t1204.331\t-880.120\t{4410.2-d[i]-f[i]/9e3:.3f}\n'
    wr('femtotools.txt', t, 'utf-8')

# 8 LabVIEW .lvm, decimal comma, units in the segment header, comment column
def lvm():
    rng = np.random.default_rng(8); L, b, h, E = 280., 20., 20., 11200.
    k = stiff(E, I_rect(b, h), L); n = 600
    d, f = curve(k, 5.3, n, rng, 'break', at=5.1, noise=1.0)
    c = lambda v: f'{v:.6f}'.replace('.', ',')
    t = 'LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t,\nMulti_Headings\tNo\nX_Columns\tOne\nTime_Pref\tRelative\nOperator\tHolzlabor\nDescription\t3-Punkt-Biegung Fichte 20x20\nDate\t2026/11/03\nTime\t14:02:11,3130000000000\n***End_of_Header***\t\n\t\n'
    t += f'Channels\t2\t\nSamples\t{n}\t{n}\t\nDate\t2026/11/03\t2026/11/03\t\nTime\t14:02:11,3130000000000\t14:02:11,3130000000000\t\nY_Unit_Label\tN\tmm\t\nX_Dimension\tTime\tTime\t\nX0\t0,0000000000000000E+0\t0,0000000000000000E+0\t\nDelta_X\t0,100000\t0,100000\t\n***End_of_Header***\t\t\t\nX_Value\tKraft\tWeg\tComment\n'
    for i in range(n): t += f'{c(i*0.1)}\t{c(f[i])}\t{c(d[i])}' + ('\tStart' if i == 0 else '') + '\n'
    wr('labview_holz.lvm', t, 'cp1252')

# 9 TA Instruments DMA Q800, Universal Analysis text, UTF-16LE, signals named down the preamble
def q800():
    rng = np.random.default_rng(9); L, b, h, E = 20., 5.12, 1.03, 5600.
    k = stiff(E, I_rect(b, h), L); n = 420
    d, f = curve(k, 0.96, n, rng, 'linear', noise=0.01)
    t = 'CLOSED\nVersion\tThermal Advantage\nProgram\tTA Universal Analysis\nLanguage\tUSA\nRun\t1\nModule\tDMA Controlled Force\nInstrument\tDMA Q800 V21.1 Build 51\nSerial #\t0800-1732\nMode\tControlled Force\nFile\tC:\\TA\\Data\\DMA\\jk\\flax-3pb.004\nSample\tflax/PLA UD 4\nSize\t20.0000 x 5.1200 x 1.0300 mm\nClamp\t3-Point Bending\nDate\t03-Nov-2026\nTime\t14:02:11\nNsig\t6\nSig1\tTime (min)\nSig2\tTemperature (°C)\nSig3\tDisplacement (µm)\nSig4\tStatic Force (N)\nSig5\tPosition (mm)\nSig6\tStress (MPa)\nOrgMethod\t1: Ramp force 3.0000 N/min to 18.0000 N\nOrgFile\tC:\\TA\\Data\\DMA\\jk\\flax-3pb.004\nStartOfData\n'
    for i in range(n): t += f'{i*0.0125:.6E}\t{29.8+0.2*math.sin(i/50):.6E}\t{d[i]*1000:.6E}\t{f[i]+0.01:.6E}\t{-7.3512-d[i]:.6E}\t{3*f[i]*L/(2*b*h*h):.6E}\n'
    wr('dma_q800.txt', t, 'utf-16')

# 10 Excel by a student: title, three rods side by side, units in a row below, results at the right
def student():
    rng = np.random.default_rng(10); L, dia = 120., 6.
    wb = openpyxl.Workbook(); ws = wb.active; ws.title = 'Sheet1'
    ws['A1'] = '3-point bending of pultruded rods - group B4'
    ws['A2'] = 'span = 120 mm'; ws['B2'] = 'd = 6 mm'; ws['D2'] = 'speed 2 mm/min'
    Es = [41000., 39500., 42300.]; ns = [410, 388, 395]
    for j, (E, n) in enumerate(zip(Es, ns)):
        d, f = curve(stiff(E, I_round(dia), L), n*0.02, n, rng, 'saw', at=3.0, slips=14, noise=0.4)
        c = 1 + 3*j
        ws.cell(4, c, f'Rod {j+1}'); ws.merge_cells(start_row=4, start_column=c, end_row=4, end_column=c+1)
        ws.cell(5, c, 'Displacement'); ws.cell(5, c+1, 'Force'); ws.cell(6, c, 'mm'); ws.cell(6, c+1, 'N')
        for i in range(n): ws.cell(7+i, c, round(float(d[i]), 4)); ws.cell(7+i, c+1, round(float(f[i]), 2))
        ws.cell(5, 11, 'Results'); ws.cell(6, 11, 'rod'); ws.cell(6, 12, 'Fmax (N)'); ws.cell(6, 13, 'E (GPa)')
        ws.cell(7+j, 11, j+1); ws.cell(7+j, 12, round(float(f.max()), 1)); ws.cell(7+j, 13, round(E/1000, 1))
    ws.cell(10, 11, 'mean'); ws.cell(10, 13, 40.9)
    w2 = wb.create_sheet('Notes'); w2.append(['Rod 2 slipped out of the support once, repeated'])
    wb.save(OUT + 'student_rods.xlsx')

# 11 Google Sheets CSV of a French user: comma-delimited, quoted decimal commas, U+202F thousands, footer
def french():
    rng = np.random.default_rng(11); L, b, h, E = 200., 25., 15., 9800.
    k = stiff(E, I_rect(b, h), L); n = 520
    d, f = curve(k, 7.28, n, rng, 'saw', at=3.5, slips=10, noise=1.5)
    def fr(v, p):
        s = f'{v:,.{p}f}'.replace(',', '\u202f').replace('.', ',')
        return f'"{s}"' if ',' in s else s
    t = 'Essai de flexion 3 points - chêne n°3,,,\nPortée (mm),200,,\nLargeur (mm),25,Épaisseur (mm),15\n,,,\nTemps (s),Flèche (mm),Charge (N),Contrainte (MPa)\n'
    for i in range(n): t += f'{fr(i*0.42,2)},{fr(d[i],3)},{fr(f[i],1)},{fr(3*f[i]*L/(2*b*h*h),2)}\n'
    t += f',,,\nForce max (N),{fr(f.max(),1)},,\nFlèche à Fmax (mm),{fr(d[f.argmax()],3)},,\nModule (MPa),"9\u202f800",,'
    wr('sheets_fr.csv', t, 'utf-8', '\r\n')

# 12 Arduino HX711 logger, copied from the serial monitor with its time stamps; grams, µm
def arduino():
    rng = np.random.default_rng(12); L, dia, E = 80., 3., 14000.
    k = stiff(E, I_round(dia), L); n = 640
    d, f = curve(k, 4.8, n, rng, 'saw', at=2.2, slips=12, noise=0.02, pre=0.15)
    def stamp(ms): s = 14*3600*1000+2*60000+11313+ms; return f'{s//3600000:02d}:{s//60000%60:02d}:{s//1000%60:02d}.{s%1000:03d} -> '
    t = stamp(0) + 'HX711 3-point bender v0.3\n' + stamp(410) + 'Taring... done, scale = 421.37\n' + stamp(412) + 't_ms;pos_um;load_g\n'
    for i in range(n):
        g = 'nan' if i == 333 else f'{f[i]/9.80665e-3:.2f}'
        t += stamp(500+i*100) + f'{500+i*100};{d[i]*1000:.1f};{g}\n'
    t += stamp(500+n*100) + 'END\n'
    wr('arduino_hx711.txt', t, 'utf-8', '\n')


def make(folder):
    global OUT
    OUT = f"{folder}/"
    for write in (bluehill, mts, zwick, shimadzu, taxt, hysitron, femto, lvm, q800, student, french, arduino):
        write()
